#pragma once

#include <vector>

#include "playhouse/geom/pose.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::app {

/// Something of a picture from above: what is inside of an odd number of the loops, in one color.
struct Shape {
  std::vector<std::vector<geom::Vec2>> loops;  // m, in W
  double z_max = 0;                            // m, in W: what is higher covers what is lower
  scene::Color color;
};

}  // namespace playhouse::app
