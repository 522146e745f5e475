#pragma once

#include <cstddef>
#include <string_view>

namespace playhouse {

/// Bytes of the UTF-8 character that the text, which is not empty, begins with; 0: it is none. Neither longer
/// forms of shorter characters, nor halves of UTF-16 pairs, nor what lies beyond Unicode.
std::size_t utf8_character(std::string_view text);

/// A byte that is a control character of ASCII.
constexpr bool is_control(char letter) {
  return static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f;
}

}  // namespace playhouse
