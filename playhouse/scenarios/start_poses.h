#pragma once

/// Where robots start: in a square by a jittered grid, in a cave on free spots. Pure functions.

#include <vector>

#include "playhouse/geom/pose.h"
#include "playhouse/scene/bitmap.h"

namespace playhouse::scenarios {

/// Radius of a circle that holds a robot however it turns; spots keep twice that from each other. [m]
inline constexpr double kRobotRadius = 0.30;

/// `count` poses in a square of `side` metres about the origin, at least kRobotRadius from its edge.
/// Needs a side of at least 2 * kRobotRadius times the root of the count, rounded up.
std::vector<geom::Pose> in_square(std::size_t count, double side);

/// `count` poses on the free pixels of `rock`, stretched over a square of `side` metres about the origin, at
/// least kRobotRadius from solid ones. Fewer if there is no room for more.
std::vector<geom::Pose> in_cave(std::size_t count, const scene::Bitmap& rock, double side);

}  // namespace playhouse::scenarios
