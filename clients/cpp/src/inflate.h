#pragma once

/// Uncompresses streams of zlib (RFC 1950 and 1951), for maps: so the library needs no other one.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace playhouse::client {

/// The `size` bytes of a stream; none if it is damaged or has another number of bytes.
std::optional<std::vector<std::byte>> inflate(std::span<const std::byte> stream, std::size_t size);

}  // namespace playhouse::client
