#pragma once

/// What sensors see, as shapes of a picture from above: scans and pings of rangers as filled fans, a line
/// from a finder to each fiducial, from a detector to each thing that it finds and from a radio to each that
/// it hears, what is in view of a camera. A kind more is an entry of the list in sensor_shapes.cc.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/app/shape.h"
#include "playhouse/base/result.h"
#include "playhouse/world/world.h"

namespace playhouse::app {

class SensorShapes {
 public:
  /// None are drawn.
  SensorShapes() = default;

  /// The words that parse() knows, as a text.
  static std::string names();
  /// Those of some kinds: their names between commas, or "all". Fails on what is no kind that is drawn.
  static Result<SensorShapes> parse(std::string_view text);

  /// Has the sensors measure for whoever looks, which changes nothing else. Before the first tick.
  void watch(world::World& world) const;

  /// Appends what has been measured, as shapes of one loop, all of which can be seen from its first corner.
  /// Lines are so broad. [m]
  void add_to(std::vector<Shape>& shapes, const world::World& world, double line_width) const;

 private:
  std::vector<std::size_t> drawn_;  // places in the list, ascending
};

}  // namespace playhouse::app
