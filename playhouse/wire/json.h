#pragma once

/// JSON serialisation, used by generated to_json() functions. Numbers are the shortest
/// that read back the same; numbers without a JSON form (nan, inf) become null.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace playhouse::wire {

/// Longest byte array printed as numbers; longer ones become {"base64":"..."}.
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

/// Up to the first NUL, quoted; invalid UTF-8 bytes are read as Latin-1.
void json_text(std::string& out, std::string_view raw);

void json_bytes(std::string& out, std::span<const std::uint8_t> bytes);
void json_bytes(std::string& out, std::span<const std::int8_t> bytes);

/// `{"name":` or `,"name":`.
void json_key(std::string& out, char opener, std::string_view name);

/// Appends a JSON array; print(out, element) appends an element.
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
