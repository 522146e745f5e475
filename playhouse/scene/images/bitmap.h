#pragma once

/// Images as bodies: image bytes -> occupancy grid of pixels -> closed contours on pixel edges.

#include <cstdint>
#include <string_view>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/base/result.h"
#include "playhouse/geom/pose.h"

namespace playhouse::scene {

/// Occupancy grid. Row 0 is the image's top row.
struct Bitmap {
  int width = 0, height = 0;
  std::vector<std::uint8_t> solid;  // height x width, row-major; 0 or 1

  bool at(int x, int y) const {
    return x >= 0 && x < width && y >= 0 && y < height &&
           solid[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(x)] != 0;
  }
};

/// Decodes a PNG, JPEG, PGM, PPM, PBM or BMP. A pixel is solid if its first channel is at most
/// 127 of 255 and its alpha is not. Fails on other bytes and on more than `most_pixels`.
Result<Bitmap> decode_bitmap(std::string_view bytes, std::size_t most_pixels = limits::kBitmapPixels);

/// True for names of files that decode_bitmap() may read.
bool is_image_name(std::string_view name);

/// Contour tracing of the solid pixels, in pixels: x right from the image's left edge, y
/// up from its bottom edge. Solid is on the left of each edge, collinear edges are merged,
/// diagonal neighbours are separate. Fails on more than `most_corners`: a few kilobytes of
/// image can contain millions of contours. Cost: one pass over pixels and one over edges.
Result<std::vector<std::vector<geom::Vec2>>> trace_contours(const Bitmap& bitmap,
                                                            std::size_t most_corners = limits::kCorners);

}  // namespace playhouse::scene
