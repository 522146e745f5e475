#pragma once

/// The image libraries behind one function each; nothing of theirs leaves image_file.cc.

#include <cstdint>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"

namespace playhouse::scene {

/// The first channel of an image, 8 bits deep.
struct FirstChannel {
  int width = 0, height = 0;
  std::vector<std::uint8_t> level;  // height x width, row-major
};

/// What ROS goes by: how light a pixel is, and how opaque.
struct Shades {
  int width = 0, height = 0;
  std::vector<std::uint16_t> color;  // height x width, row-major: red + green + blue, 0 to 765
  std::vector<std::uint8_t> alpha;   // the same, 0 to 255; empty where the image has none
};

/// Reads a PNG through libpng, a BMP through stb_image, and a PNM of any kind itself (stb_image reads two of
/// the six and overflows on hostile headers). Fails on more than `most_pixels` before it allocates any.
Result<FirstChannel> read_first_channel(std::string_view bytes, std::size_t most_pixels);
Result<Shades> read_shades(std::string_view bytes, std::size_t most_pixels);

}  // namespace playhouse::scene
