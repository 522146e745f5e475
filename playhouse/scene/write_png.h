#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "playhouse/base/result.h"

namespace playhouse::scene {

/// A PNG file of 8-bit red, green and blue, rows from the top. Needs width * height * 3 bytes. Fails where
/// libpng does: out of memory.
Result<std::string> png_of(int width, int height, std::span<const std::uint8_t> rgb);

}  // namespace playhouse::scene
