#pragma once

/// Appends values as JSON text: what generated to_json() functions are made of. Numbers are the shortest that read
/// back the same; a number JSON cannot express (nan, inf) is null.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace playhouse::wire {

/// Longest byte array that is printed as numbers; a longer one is {"base64":"..."}.
inline constexpr std::size_t kJsonByteNumbers = 1024;

void json_value(std::string& out, char value);
void json_value(std::string& out, std::int8_t value);
void json_value(std::string& out, std::uint8_t value);
void json_value(std::string& out, std::int16_t value);
void json_value(std::string& out, std::uint16_t value);
void json_value(std::string& out, std::int32_t value);
void json_value(std::string& out, std::uint32_t value);
void json_value(std::string& out, std::int64_t value);
void json_value(std::string& out, float value);
void json_value(std::string& out, double value);

/// Up to the first NUL, quoted; bytes that are no UTF-8 become the Latin-1 characters of the same number.
void json_text(std::string& out, std::string_view raw);

void json_bytes(std::string& out, std::span<const std::uint8_t> bytes);
void json_bytes(std::string& out, std::span<const std::int8_t> bytes);

/// `{"name":` or `,"name":`.
void json_key(std::string& out, char opener, std::string_view name);

/// Elements by the to_json() or json_value() of their type.
template <typename Array, typename Print>
void json_array(std::string& out, const Array& values, Print print) {
  out += '[';
  bool first = true;
  for (const auto& value : values) {
    if (!first) out += ',';
    first = false;
    print(out, value);
  }
  out += ']';
}

}  // namespace playhouse::wire
