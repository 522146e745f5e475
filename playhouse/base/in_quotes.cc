#include "playhouse/base/in_quotes.h"

#include <fmt/format.h>

#include <iterator>

namespace playhouse {
namespace {

constexpr std::size_t kShownBytes = 200;

}  // namespace

std::string in_quotes(std::string_view text) {
  const bool fits = text.size() <= kShownBytes;
  return '"' + escaped(text.substr(0, kShownBytes)) + (fits ? "\"" : "...\"");
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
