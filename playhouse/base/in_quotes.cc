#include "playhouse/base/in_quotes.h"

namespace playhouse {
namespace {

constexpr std::size_t kShownBytes = 200;
constexpr char kHexDigits[] = "0123456789abcdef";

/// The beginning of a text, without a part of a UTF-8 character at its end.
std::string_view beginning(std::string_view text) {
  const auto goes_on = [&](std::size_t i) { return (static_cast<unsigned char>(text[i]) & 0xc0) == 0x80; };
  constexpr std::size_t kLongest = 4;  // bytes of a character
  std::size_t end = kShownBytes;
  while (end > kShownBytes - kLongest && goes_on(end)) --end;
  return text.substr(0, end);
}

/// Of a character, by its first byte; 0: none begins so.
std::size_t announced_bytes(unsigned char first) {
  return first < 0x80 ? 1 : first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
}

/// Bytes of the UTF-8 character that the text begins with; 0: it is none. Neither longer forms of shorter
/// characters, nor halves of UTF-16 pairs, nor what lies beyond Unicode.
std::size_t utf8_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t size = announced_bytes(byte(0));
  if (size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
  }
  const bool longer = (byte(0) == 0xe0 && byte(1) < 0xa0) || (byte(0) == 0xf0 && byte(1) < 0x90);
  const bool foreign = (byte(0) == 0xed && byte(1) >= 0xa0) || (byte(0) == 0xf4 && byte(1) >= 0x90);
  return longer || foreign ? 0 : size;
}

bool is_control(char letter) {
  return static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f;
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
