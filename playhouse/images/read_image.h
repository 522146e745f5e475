#pragma once

/// Decodes images: bitmaps of worlds and maps, textures of meshes, pictures of the page. Types of the image
/// libraries do not leave read_image.cc.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"

namespace playhouse::images {

/// The first channel, 8 bits; 255 where it is mostly transparent.
struct FirstChannel {
  int width = 0, height = 0;
  std::vector<std::uint8_t> level;  // height x width, rows from the top
};

/// Brightness and opacity, as ROS map thresholds need them.
struct Shades {
  int width = 0, height = 0;
  std::vector<std::uint16_t> color;  // height x width, rows from the top: red + green + blue, 0 to 765
  std::vector<std::uint8_t> alpha;   // likewise, 0 to 255; empty without an alpha channel
};

/// 8-bit colors, composited over black.
struct RgbImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  // height x width x 3, rows from the top
};

/// 8-bit colors with alpha.
struct RgbaImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // height x width x 4, rows from the top
};

struct ImageLimits {
  std::size_t pixels = 0;
  std::size_t side = std::numeric_limits<std::size_t>::max();  // px
};

/// Decodes PNG by libpng, JPEG by libjpeg-turbo, BMP by stb_image, and all PNM formats by own code (stb_image
/// supports two of six and overflows on hostile headers) to one of the types above. Samples are taken as they
/// are, without gamma or profiles. Fails, without a file name, on other bytes, on files that end early and,
/// before allocating, beyond the limits.
template <typename Image>
Result<Image> read_image(std::string_view bytes, const ImageLimits& most);

}  // namespace playhouse::images
