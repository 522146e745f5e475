#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace playhouse::mesh {

inline constexpr std::string_view kBlank = " \t\v\r\n";

/// Strips leading and trailing white space.
inline std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlank), text.size()));
  return text.substr(0, text.find_last_not_of(kBlank) + 1);
}

/// Of ASCII letters.
inline std::string lower(std::string_view text) {
  std::string small(text);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

}  // namespace playhouse::mesh
