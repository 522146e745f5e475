#pragma once

/// Adapters from typed payloads to the functions
/// of MessageDef. Included by generated/*.cc only.

#include "playhouse/wire/codec.h"
#include "playhouse/wire/messages.h"

namespace playhouse::wire {

template <typename T>
std::string check_required(std::span<const std::byte> body) {
  Reader reader(body);
  T value;
  read(reader, value);
  return reader.error();
}

template <typename T>
std::string check_optional(std::span<const std::byte> body) {
  return body.empty() ? std::string() : check_required<T>(body);
}

template <typename T>
std::vector<std::byte> reencode(std::span<const std::byte> body) {
  const Result<T> value = decode<T>(body);
  return value ? encode(*value) : std::vector<std::byte>();
}

#if defined(PLAYHOUSE_WITHOUT_JSON)  // a program that writes none has neither it nor the names of fields
template <typename T>
inline constexpr void (*body_to_json)(std::span<const std::byte>, std::string&) = nullptr;
#else
template <typename T>
void body_to_json(std::span<const std::byte> body, std::string& out) {
  const Result<T> value = decode<T>(body);
  if (value) {
    to_json(out, *value);
  } else {
    out += "null";
  }
}
#endif

inline std::string check_nothing(std::span<const std::byte>) {
  return {};
}
inline std::vector<std::byte> reencode_nothing(std::span<const std::byte>) {
  return {};
}
inline void nothing_to_json(std::span<const std::byte>, std::string& out) {
  out += "null";
}

}  // namespace playhouse::wire
