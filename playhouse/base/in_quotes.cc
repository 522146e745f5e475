#include "playhouse/base/in_quotes.h"

#include <fmt/format.h>

#include <iterator>

namespace playhouse {
namespace {

constexpr std::size_t kShownBytes = 200;

/// The beginning of a text, without a part of a UTF-8 character at its end.
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
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (code < 0x20 || code == 0x7f) {
      fmt::format_to(std::back_inserter(result), "\\x{:02x}", code);
    } else {
      result += letter;
    }
  }
  return result;
}

}  // namespace playhouse
