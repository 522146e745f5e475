#pragma once

/// Conversion of poses and sizes to those of the wire.

#include "playhouse/geom/orientation.h"
#include "playhouse/geom/pose.h"
#include "playhouse/wire/generated/common.h"

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
/// Width is along y, length along x.
inline wire::Bbox3d bbox3d(const geom::Size& size) {
  return {size.y, size.x, size.z};
}

}  // namespace playhouse::drivers
