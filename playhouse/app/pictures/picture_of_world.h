#pragma once

/// Software rendering of a world from above: bodies in their
/// colours, painted by height, anti-aliased, with a dark nose
/// on everything that drives; optionally with sensor data.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "playhouse/app/pictures/sensor_shapes.h"
#include "playhouse/base/result.h"
#include "playhouse/geom/orientation.h"
#include "playhouse/scene/images/read_png.h"
#include "playhouse/world/world.h"

namespace playhouse::app {

/// A camera in the world, without roll.
struct Eye {
  geom::Vec3 p;                      // m, W
  double yaw = 0, pitch = 0;         // rad; pitch positive up
  double fov = 1;                    // rad, vertical
  std::optional<world::ModelId> of;  // whose eye it is: its tree is not drawn
};

/// A viewport: pixel (0, 0) has the world coordinates `left`, `top` at its corner; x goes right and y up.
struct Viewport {
  int width = 0, height = 0;  // pixels
  double left = 0, top = 0;   // m
  double pixels_per_metre = 1;
  /// The camera; the place and the scale above then have no meaning. None: from above.
  std::optional<Eye> eye = {};

  /// Line width for sensor data. [m]
  double line_width() const { return eye ? 0.01 : 1.5 / pixels_per_metre; }
};

/// A viewport of this width in pixels around all bodies, with a margin; ten metres
/// around the origin if there are none. Fails beyond limits::kPicturePixels.
Result<Viewport> view_of(const world::World& world, int width);

/// `seen` selects the sensor data to draw.
scene::RgbImage picture_of(const world::World& world, const Viewport& view, const SensorShapes& seen);

}  // namespace playhouse::app
