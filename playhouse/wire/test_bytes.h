#pragma once

/// For tests: hexadecimal byte literals.

#include <cstddef>
#include <string_view>
#include <vector>

namespace playhouse::wire {

/// "00000001 ff00" -> {0, 0, 0, 1, 255, 0}; spaces are ignored.
inline std::vector<std::byte> bytes_of(std::string_view hex) {
  std::vector<std::byte> out;
  unsigned value = 0;
  int digits = 0;
  for (const char c : hex) {
    if (c == ' ' || c == '\n') continue;
    value = value << 4 | static_cast<unsigned>(c >= 'a' ? c - 'a' + 10 : c - '0');
    if (++digits % 2 == 0) out.push_back(static_cast<std::byte>(value & 0xFF));
  }
  return out;
}

}  // namespace playhouse::wire
