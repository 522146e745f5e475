#pragma once

/// Start poses of robots: on a jittered grid in a square, on free spots in a cave. Pure functions.

#include <vector>

#include "playhouse/geom/pose.h"
#include "playhouse/scene/images/bitmap.h"

namespace playhouse::scenarios {

/// Bounding circle of a Pioneer at any heading; spots are twice that apart. [m]
inline constexpr double kRobotRadius = 0.30;

/// `count` poses in a square of `side` metres around the origin, at least `radius` from its edge and
/// twice that apart. Needs a side of at least 2 * radius times the root of the count, rounded up.
std::vector<geom::Pose> in_square(std::size_t count, double side, double radius = kRobotRadius);

/// Poses at these spots, jittered by at most `jitter` along each axis [m], at random headings.
std::vector<geom::Pose> about(const std::vector<geom::Vec2>& spots, double jitter);

/// `count` poses on the free pixels of `rock`, scaled to a square of `side` metres around
/// the origin, at least kRobotRadius from solid ones. Fewer if there is no more room.
std::vector<geom::Pose> in_cave(std::size_t count, const scene::Bitmap& rock, double side);

/// `count` poses in such caves at these places, `each` in one except the
/// last, at different spots in every cave. Needs a cave with room for `each`.
std::vector<geom::Pose> in_caves(std::size_t count, const scene::Bitmap& rock, double side, std::size_t each,
                                 const std::vector<geom::Pose>& caves);

}  // namespace playhouse::scenarios
