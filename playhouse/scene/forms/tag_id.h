#pragma once

/// Ids of radio tags, as world files have them. A pure function.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace playhouse::scene {

/// The longest id: an EPC is 31 words of 16 bits at most, as the length in its protocol control word has five
/// bits (EPC Gen2, 6.3.2.1.2.2).
inline constexpr std::size_t kTagIdBytes = 62;

/// The bytes of pairs of hexadecimal digits, with or without spaces between pairs; none if it is anything else,
/// empty or longer than kTagIdBytes.
std::optional<std::string> tag_id(std::string_view text);

}  // namespace playhouse::scene
