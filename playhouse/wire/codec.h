#pragma once

/// Encoding and decoding of message bodies. T is any struct of generated/; its read(), write() come by ADL.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/base/assert.h"
#include "playhouse/base/result.h"
#include "playhouse/wire/reader.h"
#include "playhouse/wire/writer.h"

namespace playhouse::wire {

/// Encodes a value. Arrays over their bound are a bug of the caller (asserted):
/// text and lists from outside have to be truncated or validated before.
template <typename T>
std::vector<std::byte> encode(const T& value) {
  // Scratch buffer, so that the body is allocated once, with its exact size.
  thread_local std::vector<std::byte> scratch;
  scratch.clear();
  Writer writer(scratch);
  write(writer, value);
  PLAYHOUSE_ASSERT(writer.ok());
  constexpr std::size_t kKept = 1 << 16;  // larger bodies, such as maps, are moved out instead of copied
  if (scratch.size() > kKept) return std::exchange(scratch, {});
  return {scratch.begin(), scratch.end()};
}

/// Decodes a body, or fails. Trailing bytes are tolerated, as the protocol requires;
/// an empty body is an error here (it means "no payload", which is up to the caller).
template <typename T>
Result<T> decode(std::span<const std::byte> body) {
  Reader reader(body);
  T value;
  read(reader, value);
  if (!reader.ok()) return Error{"", reader.error()};
  return value;
}

/// Text in wire format: NUL-terminated.
std::string c_string(std::string_view text);

/// Text up to the first NUL.
std::string_view text(std::string_view raw);

}  // namespace playhouse::wire
