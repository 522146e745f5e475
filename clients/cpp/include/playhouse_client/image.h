#pragma once

/// A picture of a camera.

#include <cstdint>
#include <vector>

#include "playhouse/base/result.h"

namespace playhouse::client {

/// A picture: rows from the top, pixels from the left.
struct Image {
  std::uint32_t width = 0, height = 0;  // px
  /// One of wire::camera::kFormatMono8, kFormatMono16 (in Playhouse: depth in mm, little-endian, 0 where
  /// nothing is in range), kFormatRgb565 and kFormatRgb888.
  std::uint32_t format = 0;
  bool is_jpeg = false;
  std::vector<std::uint8_t> data;  // those pixels; of a JPEG, the whole file
  double time = 0;                 // the server's, of these data [s]

  /// Channels of one pixel: red, green and blue; or grey level; or depth in mm. An error for JPEG data, for
  /// other formats, outside the image, and if the data are shorter than the pixels.
  Result<std::vector<std::uint16_t>> pixel(std::uint32_t column, std::uint32_t row) const;
};

}  // namespace playhouse::client
