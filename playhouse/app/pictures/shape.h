#pragma once

#include <vector>

#include "playhouse/geom/pose.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::app {

/// A filled shape in a picture from above: the even-odd inside of the loops, in one colour.
struct FilledShape {
  std::vector<std::vector<geom::Vec2>> loops;  // m, in W
  double z_max = 0;                            // m, in W: painting order
  scene::Color color;
  bool each = false;  // the inside of each loop by itself: without gaps where they touch
};

}  // namespace playhouse::app
