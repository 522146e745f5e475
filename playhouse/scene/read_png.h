#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"

namespace playhouse::scene {

/// 8-bit red, green and blue, rows from the top.
struct RgbImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// The colors of a PNG file; what one can see through is over black. Fails on what is none, and, before it
/// allocates any, on more than `most_pixels`.
Result<RgbImage> read_rgb(std::string_view png, std::size_t most_pixels);

}  // namespace playhouse::scene
