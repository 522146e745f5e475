#pragma once

/// JSON of what the program tells of itself (`playhouse kinds`, `playhouse drivers`).

#include <string>
#include <string_view>

#include "playhouse/wire/json.h"

namespace playhouse::app {

/// JSON string, or null if empty.
inline std::string json_or_null(std::string_view text) {
  if (text.empty()) return "null";
  std::string out;
  wire::json_text(out, std::string(text));
  return out;
}

template <typename Range, typename Write>
std::string json_list(const Range& items, Write write) {
  std::string text;
  for (const auto& item : items) text += (text.empty() ? "" : ",") + write(item);
  return "[" + text + "]";
}

}  // namespace playhouse::app
