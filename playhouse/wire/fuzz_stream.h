#pragma once

/// For the fuzz targets: decodes and re-encodes a stream of messages, like a session.

#include <cstddef>
#include <span>
#include <string>

#include "playhouse/base/assert.h"
#include "playhouse/wire/messages.h"

namespace playhouse::wire {

/// Invariants for any body of a known message: check and
/// reencode agree, reencode is idempotent, JSON never fails.
inline void fuzz_body(const MessageDef& row, std::span<const std::byte> body) {
  const bool acceptable = row.check(body).empty();
  const auto once = row.reencode(body);
  if (row.has_payload && !body.empty()) PLAYHOUSE_ASSERT(acceptable == !once.empty());
  PLAYHOUSE_ASSERT(once.size() <= body.size());
  PLAYHOUSE_ASSERT(row.reencode(once) == once);
  std::string json;
  row.to_json(body, json);
  PLAYHOUSE_ASSERT(!json.empty());
}

/// A sequence of header, body, header, body, ... The last body may be truncated.
inline void fuzz_stream(std::span<const std::byte> stream) {
  while (stream.size() >= limits::kHeaderBytes) {
    const Header header = decode_header(stream.first<limits::kHeaderBytes>());
    stream = stream.subspan(limits::kHeaderBytes);
    const auto body = stream.first(header.size < stream.size() ? header.size : stream.size());
    if (const MessageDef* row = find_message(header.interf, header.type, header.subtype))
      fuzz_body(*row, body);
    stream = stream.subspan(body.size());
  }
}

}  // namespace playhouse::wire
