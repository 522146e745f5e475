#pragma once

#include "playhouse/bridge/interfaces/pose_on_robot.h"
#include "playhouse/geom/orientation.h"
#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// Pose of a model's body, the sensor frame, in the robot that carries it; in the world if none does.
geom::SpatialPose pose_on_robot(const world::World& world, world::ModelRow model);

}  // namespace playhouse::drivers
