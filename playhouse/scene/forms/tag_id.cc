#include "playhouse/scene/forms/tag_id.h"

namespace playhouse::scene {
namespace {

/// 16 for what is no digit.
unsigned digit_value(char digit) {
  if (digit >= '0' && digit <= '9') return static_cast<unsigned>(digit - '0');
  if (digit >= 'a' && digit <= 'f') return static_cast<unsigned>(digit - 'a') + 10;
  if (digit >= 'A' && digit <= 'F') return static_cast<unsigned>(digit - 'A') + 10;
  return 16;
}

}  // namespace

std::optional<std::string> tag_id(std::string_view text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); i += 2) {
    while (i < text.size() && text[i] == ' ') ++i;
    if (i == text.size()) break;
    if (i + 1 == text.size()) return std::nullopt;
    const unsigned high = digit_value(text[i]), low = digit_value(text[i + 1]);
    if (high > 15 || low > 15) return std::nullopt;
    bytes += static_cast<char>(16 * high + low);
  }
  if (bytes.empty() || bytes.size() > kTagIdBytes) return std::nullopt;
  return bytes;
}

}  // namespace playhouse::scene
