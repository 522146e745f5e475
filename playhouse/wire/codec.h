#pragma once

/// Whole values to whole bodies and back. T is any struct of generated/; its read() and write() are found by name.

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

/// The body that carries `value`. Arrays over their bound are a bug of the caller (asserted): text and lists that
/// come from outside are cut or checked before they are put into a value.
template <typename T>
std::vector<std::byte> encode(const T& value) {
  // A scratch buffer, so that the body is allocated once, at its size.
  thread_local std::vector<std::byte> scratch;
  scratch.clear();
  Writer writer(scratch);
  write(writer, value);
  PLAYHOUSE_ASSERT(writer.ok());
  constexpr std::size_t kKept = 1 << 16;  // a map's bytes are not worth a copy, and not kept
  if (scratch.size() > kKept) return std::exchange(scratch, {});
  return {scratch.begin(), scratch.end()};
}

/// The value that a body carries, or what is wrong with the body. Bytes after the value are tolerated, as the
/// protocol says; an empty body is a fault here (it means "no payload", which only the caller can judge).
template <typename T>
Result<T> decode(std::span<const std::byte> body) {
  Reader reader(body);
  T value;
  read(reader, value);
  if (!reader.ok()) return Error{"", reader.error()};
  return value;
}

/// Text as the wire wants it: with its final NUL.
std::string c_string(std::string_view text);

/// Text as people want it: up to the first NUL.
std::string_view text(std::string_view raw);

}  // namespace playhouse::wire
