#pragma once

/// Frames of a recording: what /tf and the headers of messages name, and where each is.
/// Frames of sensors are those of their measurements; that of a camera's lens is an optical
/// one (REP 103): z into the image, x to its right, y down.

#include <cstdint>
#include <string>

#include "playhouse/world/world.h"

namespace playhouse::record {

enum class FrameKind : std::uint8_t {
  kModel,
  kRangerSensor,
  kBody,      // of an imu or a gps: the frame of its body
  kLens,      // of a camera
  kOdometry,  // of a robot: where its estimated pose is measured from
};

/// Name of a frame of the model with this label; `sensor` is the nth of a ranger.
std::string frame_name(const std::string& label, FrameKind kind, std::uint32_t sensor = 0);

geom::SpatialPose frame_in_world(const world::World& world, world::ModelRow model, FrameKind kind,
                                 std::uint32_t sensor = 0);

/// Pose of frame F in frame P.
geom::SpatialPose pose_in(const geom::SpatialPose& X_WP, const geom::SpatialPose& X_WF);

/// A robot's estimate of its pose, in its odometry frame.
/// Height and tilt, which it does not estimate, are the true ones.
geom::SpatialPose estimated_pose(const world::World& world, world::ModelRow model);

}  // namespace playhouse::record
