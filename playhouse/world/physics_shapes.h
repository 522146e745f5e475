#pragma once

/// Collision shapes of an engine, for display and for programs that
/// predict motion. Frames: W world, B root of a tree of models.

#include <vector>

#include "playhouse/geom/orientation.h"
#include "playhouse/world/model_id.h"

namespace playhouse::world {

/// Corners of a solid: for an upright prism those of its bottom in order, then those
/// of its top in the same order; for any other, which is convex, in any order. [m]
using SolidCorners = std::vector<geom::Vec3>;

struct PhysicsShapes {
  struct Body {
    ModelId model;                     // the root of its tree
    std::vector<SolidCorners> solids;  // in B
  };
  std::vector<SolidCorners> fixed;  // static solids, in W
  std::vector<Body> bodies;         // movable bodies, by id
};

}  // namespace playhouse::world
