#pragma once

/// Between the world's poses and sizes and the wire's, and what every device of a model needs to know about
/// time and place.

#include <cstdint>

#include "playhouse/wire/generated/common.h"
#include "playhouse/world/world.h"

namespace playhouse::drivers {

inline wire::Pose2d pose2d(const geom::Pose& X) {
  return {X.x, X.y, X.a};
}
inline wire::Pose2d pose2d(const geom::Twist& v) {
  return {v.x, v.y, v.a};
}
inline wire::Pose3d pose3d(const geom::Pose& X) {
  return {X.x, X.y, X.z, 0, 0, X.a};
}
inline wire::Pose3d pose3d(const geom::SpatialPose& X) {
  const geom::RollPitchYaw turns = geom::roll_pitch_yaw(X.X.a, X.tilt);
  return {X.X.x, X.X.y, X.X.z, turns.roll, turns.pitch, turns.yaw};
}
/// Width is across (y), length along (x).
inline wire::Bbox3d bbox3d(const geom::Size& size) {
  return {size.y, size.x, size.z};
}

/// The pose of a model's body and sensor frame in the robot that carries it; in the world if nothing does.
geom::Pose pose_on_robot(const world::World& world, world::ModelRow model);

}  // namespace playhouse::drivers
