#include "playhouse/world/speech.h"

#include "playhouse/base/limits.h"
#include "playhouse/base/utf8.h"

namespace playhouse::world {

std::string spoken(std::string_view text) {
  std::string line;
  std::string_view rest = text.substr(0, text.find('\0'));
  while (!rest.empty()) {
    const std::size_t size = utf8_character(rest);
    const std::string_view character = size == 0 ? "?" : is_control(rest[0]) ? " " : rest.substr(0, size);
    if (line.size() + character.size() > limits::kSayBytes) break;
    line += character;
    rest.remove_prefix(size == 0 ? 1 : size);
  }
  return line;
}

bool can_be_said(std::string_view text) {
  if (text.size() > limits::kSayBytes) return false;
  while (!text.empty()) {
    const std::size_t size = utf8_character(text);
    if (size == 0 || is_control(text[0])) return false;
    text.remove_prefix(size);
  }
  return true;
}

}  // namespace playhouse::world
