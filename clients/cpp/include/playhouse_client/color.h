#pragma once

/// Colors.

#include <array>
#include <cstdint>

namespace playhouse::client {

/// Red, green, blue, 0 to 255.
using Rgb = std::array<std::uint8_t, 3>;

}  // namespace playhouse::client
