#include "playhouse/base/in_quotes.h"

#include "playhouse/base/utf8.h"

namespace playhouse {
namespace {

constexpr std::size_t kShownBytes = 200;
constexpr char kHexDigits[] = "0123456789abcdef";

/// Truncates a text without splitting a UTF-8 character.
std::string_view beginning(std::string_view text) {
  const auto goes_on = [&](std::size_t i) { return (static_cast<unsigned char>(text[i]) & 0xc0) == 0x80; };
  constexpr std::size_t kLongest = 4;  // bytes of a character
  std::size_t end = kShownBytes;
  while (end > kShownBytes - kLongest && goes_on(end)) --end;
  return text.substr(0, end);
}

}  // namespace

std::string in_quotes(std::string_view text) {
  return text.size() <= kShownBytes ? '"' + escaped(text) + '"' : '"' + escaped(beginning(text)) + "...\"";
}

std::string escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t size = utf8_character(text);
    if (size == 0 || is_control(text[0])) {
      const auto byte = static_cast<unsigned char>(text[0]);
      result += "\\x";
      result += kHexDigits[byte >> 4];
      result += kHexDigits[byte & 15];
      text.remove_prefix(1);
    } else {
      result += text.substr(0, size);
      text.remove_prefix(size);
    }
  }
  return result;
}

}  // namespace playhouse
