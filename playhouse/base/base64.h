#pragma once

/// Bytes as text of 64 characters, with padding (RFC 4648, section 4).

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace playhouse {

/// Appends the text of some bytes.
void append_base64(std::string& out, std::span<const std::uint8_t> bytes);

/// The bytes of a text; none where it is no such text.
std::optional<std::string> bytes_of_base64(std::string_view text);

}  // namespace playhouse
