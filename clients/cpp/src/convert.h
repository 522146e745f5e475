#pragma once

/// Conversions between the wire structs and those of pose.h.

#include "playhouse/wire/generated/common.h"
#include "playhouse_client/pose.h"

namespace playhouse::client {

inline Pose pose(const wire::Pose2d& p) {
  return {p.px, p.py, p.pa};
}
inline Velocity velocity(const wire::Pose2d& p) {
  return {p.px, p.py, p.pa};
}
inline Pose3d pose(const wire::Pose3d& p) {
  return {p.px, p.py, p.pz, p.proll, p.ppitch, p.pyaw};
}
inline wire::Pose2d on_wire(const Pose& p) {
  return {p.x, p.y, p.a};
}
inline wire::Pose3d on_wire(const Pose3d& p) {
  return {p.x, p.y, p.z, p.roll, p.pitch, p.yaw};
}
inline Size size(const wire::Bbox3d& s) {
  return {s.sl, s.sw, s.sh};
}

}  // namespace playhouse::client
