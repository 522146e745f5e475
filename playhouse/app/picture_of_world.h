#pragma once

/// Pictures of a world from above, drawn without a screen: every body in its color, higher ones over lower
/// ones, with the edges of pixels that are partly covered mixed, and a dark nose on everything that drives;
/// with them, what sensors see.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "playhouse/app/sensor_shapes.h"
#include "playhouse/base/result.h"
#include "playhouse/geom/pose.h"
#include "playhouse/world/world.h"

namespace playhouse::app {

/// 8-bit red, green and blue, rows from the top.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// What a picture shows: pixel (0, 0) has the corner `left`, `top` of the world, x goes right and y up.
struct View {
  int width = 0, height = 0;  // pixels
  double left = 0, top = 0;   // m
  double pixels_per_metre = 1;

  /// How broad lines of what sensors see are. [m]
  double line_width() const { return 1.5 / pixels_per_metre; }
};

/// All bodies of a world with a margin, in a picture of so many pixels across; where there are none, ten
/// metres about the origin. Fails on more pixels than limits::kPicturePixels.
Result<View> view_of(const world::World& world, int width);

/// `seen` is what is drawn of the sensors.
Picture picture_of(const world::World& world, const View& view, const SensorShapes& seen);

}  // namespace playhouse::app
