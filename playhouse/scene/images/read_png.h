#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"

namespace playhouse::scene {

/// 8-bit RGB, rows from the top.
struct RgbImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Decodes a PNG to RGB, composited over black. Fails on other
/// bytes and, before allocating, on more than `most_pixels`.
Result<RgbImage> read_rgb(std::string_view png, std::size_t most_pixels);

}  // namespace playhouse::scene
