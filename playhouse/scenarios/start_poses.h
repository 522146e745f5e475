#pragma once

/// Where robots start: in a square by a jittered grid, in a cave on free spots. Pure functions.

#include <vector>

#include "playhouse/geom/pose.h"
#include "playhouse/scene/bitmap.h"

namespace playhouse::scenarios {

/// Radius of a circle that holds a Pioneer however it turns; spots keep twice that from each other. [m]
inline constexpr double kRobotRadius = 0.30;

/// `count` poses in a square of `side` metres about the origin, at least `radius` from its edge and twice
/// that from each other. Needs a side of at least 2 * radius times the root of the count, rounded up.
std::vector<geom::Pose> in_square(std::size_t count, double side, double radius = kRobotRadius);

/// Poses at these spots, each moved by at most `jitter` along either axis [m], with any heading.
std::vector<geom::Pose> about(const std::vector<geom::Vec2>& spots, double jitter);

/// `count` poses on the free pixels of `rock`, stretched over a square of `side` metres about the origin, at
/// least kRobotRadius from solid ones. Fewer if there is no room for more.
std::vector<geom::Pose> in_cave(std::size_t count, const scene::Bitmap& rock, double side);

/// `count` poses in such caves at these places, `each` in one but the last. In every cave they start
/// at other spots. Needs a cave with room for `each`.
std::vector<geom::Pose> in_caves(std::size_t count, const scene::Bitmap& rock, double side, std::size_t each,
                                 const std::vector<geom::Pose>& caves);

}  // namespace playhouse::scenarios
