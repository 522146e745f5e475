#pragma once

/// Messages of ROS for robots and their sensors beside those of their tables: what programs
/// for ROS 2 subscribe to. Each is that of the model's newest measurement; `frame` is that of frames.h.
/// Source: REP 103, 105 and 145, and the definitions of common_interfaces.

#include <cstdint>
#include <string>

#include "playhouse/record/cdr.h"
#include "playhouse/record/mcap/mcap.h"
#include "playhouse/world/world.h"

namespace playhouse::record {

/// A robot's estimate of its pose, and its velocity in its own frame `child`.
Bytes odometry_message(std::uint64_t ns, const std::string& frame, const std::string& child,
                       const world::World& world, world::ModelRow model);

/// Readings, and the estimated orientation in W.
Bytes imu_message(std::uint64_t ns, const std::string& frame, const world::World& world,
                  world::ModelRow model);

/// The newest fix; NaN and STATUS_NO_FIX with too few satellites for one.
Bytes fix_message(std::uint64_t ns, const std::string& frame, const world::World& world,
                  world::ModelRow model);

/// Intrinsics of a camera at its present zoom.
Bytes camera_info_message(std::uint64_t ns, const std::string& frame, const world::World& world,
                          world::ModelRow model);

/// All rings of a ranger's sensor, the nth: a row per ring, from the lowest; NaN where nothing returned.
/// Empty if the engine has no rings.
Bytes cloud_message(std::uint64_t ns, const std::string& frame, const world::World& world,
                    world::ModelRow model, std::uint32_t sensor);

}  // namespace playhouse::record
