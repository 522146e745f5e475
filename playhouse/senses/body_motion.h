#pragma once

/// Where a body is and how it moves, for sensors that feel it.

#include "playhouse/geom/orientation.h"
#include "playhouse/world/world.h"

namespace playhouse::senses {

/// X_WB of the body of a model.
inline geom::SpatialPose body_pose(const world::World& world, world::ModelRow model) {
  return geom::compose({world.models.X_WM[model], world.models.tilt_WM[model]},
                       {world.desc(model).X_MB, geom::Tilt{}});
}

/// X_WC of the middle of that body.
inline geom::SpatialPose middle_of_body(const world::World& world, world::ModelRow model) {
  return geom::compose(body_pose(world, model), {{0, 0, world.desc(model).size.z / 2, 0}, geom::Tilt{}});
}

/// Velocity of a point of a tree: of its rigid body, or in the 2D engine that which
/// the robot drives at, unless it is stalled.  [m/s, in W]
geom::Vec3 velocity_at(const world::World& world, world::ModelRow root, const geom::Vec3& p);

}  // namespace playhouse::senses
