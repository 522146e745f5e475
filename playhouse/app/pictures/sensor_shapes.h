#pragma once

/// Sensor data as shapes for pictures from above: scans and sonar cones as filled fans,
/// lines from a finder to its fiducials, a detector to its detections and a radio to its
/// links, view fields of cameras. A new kind is an entry in the list in sensor_shapes.cc.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/app/pictures/shape.h"
#include "playhouse/base/result.h"
#include "playhouse/world/world.h"

namespace playhouse::app {

class SensorShapes {
 public:
  /// Selects none.
  SensorShapes() = default;

  bool empty() const { return drawn_.empty(); }

  /// The names that parse() accepts, as a text.
  static std::string names();
  /// Parses comma-separated kinds, or "all". Fails on unknown ones.
  static Result<SensorShapes> parse(std::string_view text);

  /// Subscribes the sensors as a passive viewer. Before the first tick.
  void watch(world::World& world) const;

  /// Appends the latest measurements as star-shaped loops,
  /// visible from their first corner. `line_width` in metres.
  void add_to(std::vector<FilledShape>& shapes, const world::World& world, double line_width) const;

 private:
  std::vector<std::size_t> drawn_;  // indices in the list, ascending
};

}  // namespace playhouse::app
