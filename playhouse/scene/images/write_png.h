#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "playhouse/base/result.h"

namespace playhouse::scene {

/// Encodes 8-bit RGB, rows from the top, as PNG. Needs width
/// * height * 3 bytes. Fails if libpng runs out of memory.
Result<std::string> png_of(int width, int height, std::span<const std::uint8_t> rgb);

}  // namespace playhouse::scene
