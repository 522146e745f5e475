#pragma once

#include <cstddef>
#include <string_view>

namespace playhouse {

/// Length in bytes of the UTF-8 character at the start of the text, which must not be empty;
/// 0 if it is invalid: overlong forms, surrogates and code points beyond Unicode included.
std::size_t utf8_character(std::string_view text);

/// True for an ASCII control character.
constexpr bool is_control(char letter) {
  return static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f;
}

}  // namespace playhouse
