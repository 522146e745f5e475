#pragma once

/// Base64 with its pad (RFC 4648, section 4).

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace playhouse {

/// Appends the encoding of some bytes.
void append_base64(std::string& out, std::span<const std::uint8_t> bytes);

/// Decodes a text; none if it is invalid.
std::optional<std::string> bytes_of_base64(std::string_view text);

}  // namespace playhouse
