#pragma once

/// Wrappers of the image libraries; their types do not leave image_file.cc.

#include <cstdint>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"

namespace playhouse::scene {

/// The first channel of an image, 8 bits; 255 where it is mostly transparent.
struct FirstChannel {
  int width = 0, height = 0;
  std::vector<std::uint8_t> level;  // height x width, row-major
};

/// Input of ROS map thresholds: brightness and opacity of pixels.
struct Shades {
  int width = 0, height = 0;
  std::vector<std::uint16_t> color;  // height x width, row-major: red + green + blue, 0 to 765
  std::vector<std::uint8_t> alpha;   // likewise, 0 to 255; empty without an alpha channel
};

/// Decodes PNG by libpng, JPEG by libjpeg-turbo, BMP by stb_image, and all PNM formats by own code (stb_image
/// supports two of six and overflows on hostile headers). Fails on more than `most_pixels` before allocating.
Result<FirstChannel> read_first_channel(std::string_view bytes, std::size_t most_pixels);
Result<Shades> read_shades(std::string_view bytes, std::size_t most_pixels);

}  // namespace playhouse::scene
