#pragma once

/// What an engine takes bodies for where they touch, for people who want to see it and for programs that
/// predict where a body will go. Frames: W world, B the top of a tree of models.

#include <vector>

#include "playhouse/geom/orientation.h"
#include "playhouse/world/model_id.h"

namespace playhouse::world {

/// Corners of a solid: of an upright prism those of its bottom, one after the other, then those above them in
/// the same order; of any other, which is convex, in no order.  [m]
using SolidCorners = std::vector<geom::Vec3>;

struct PhysicsShapes {
  struct Body {
    ModelId model;                     // the top of its tree
    std::vector<SolidCorners> solids;  // in B
  };
  std::vector<SolidCorners> fixed;  // what stands still, in W
  std::vector<Body> bodies;         // what may move, by id
};

}  // namespace playhouse::world
