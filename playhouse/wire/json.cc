#include "playhouse/wire/json.h"

#include <array>
#include <charconv>
#include <cmath>

#include "playhouse/base/base64.h"
#include "playhouse/base/utf8.h"

namespace playhouse::wire {

namespace {

template <typename Number>
void append_number(std::string& out, Number value) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  out.append(digits.data(), end);
}

template <typename Float>
void append_float(std::string& out, Float value) {
  if (std::isfinite(value)) {
    append_number(out, value);
  } else {
    out += "null";
  }
}

void append_escape(std::string& out, unsigned char c) {
  constexpr std::string_view kHex = "0123456789abcdef";
  out += "\\u00";
  out += kHex[c >> 4];
  out += kHex[c & 15];
}

}  // namespace

void json_value(std::string& out, char value) {
  append_number(out, static_cast<int>(static_cast<signed char>(value)));
}
void json_value(std::string& out, std::int8_t value) {
  append_number(out, static_cast<int>(value));
}
void json_value(std::string& out, std::uint8_t value) {
  append_number(out, static_cast<int>(value));
}
void json_value(std::string& out, std::int16_t value) {
  append_number(out, value);
}
void json_value(std::string& out, std::uint16_t value) {
  append_number(out, value);
}
void json_value(std::string& out, std::int32_t value) {
  append_number(out, value);
}
void json_value(std::string& out, std::uint32_t value) {
  append_number(out, value);
}
void json_value(std::string& out, std::int64_t value) {
  append_number(out, value);
}
void json_value(std::string& out, float value) {
  append_float(out, value);
}
void json_value(std::string& out, double value) {
  append_float(out, value);
}

void json_text(std::string& out, std::string_view raw) {
  std::string_view rest = raw.substr(0, raw.find('\0'));
  out += '"';
  while (!rest.empty()) {
    const auto c = static_cast<unsigned char>(rest[0]);
    const std::size_t length = utf8_character(rest);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += rest[0];
    } else if (c < 0x20 || length == 0) {
      append_escape(out, c);
    } else {
      out += rest.substr(0, length);
    }
    rest.remove_prefix(length == 0 ? 1 : length);
  }
  out += '"';
}

void json_bytes(std::string& out, std::span<const std::uint8_t> bytes) {
  if (bytes.size() <= kJsonByteNumbers) {
    json_array(out, bytes, [](std::string& to, std::uint8_t value) { json_value(to, value); });
    return;
  }
  out += "{\"base64\":\"";
  append_base64(out, bytes);
  out += "\"}";
}

void json_bytes(std::string& out, std::span<const std::int8_t> bytes) {
  if (bytes.size() <= kJsonByteNumbers) {
    json_array(out, bytes, [](std::string& to, std::int8_t value) { json_value(to, value); });
    return;
  }
  json_bytes(out, std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
}

void json_key(std::string& out, char opener, std::string_view name) {
  out += opener;
  out += '"';
  out += name;
  out += "\":";
}

}  // namespace playhouse::wire
