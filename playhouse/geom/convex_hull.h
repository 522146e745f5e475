#pragma once

#include <vector>

#include "playhouse/geom/pose.h"

namespace playhouse::geom {

/// Convex hull of points, counter-clockwise; fewer than three corners if the points are collinear.
/// Cost   O(n log n), a sort of the points
/// Source Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979
std::vector<Vec2> convex_hull(std::vector<Vec2> points);

}  // namespace playhouse::geom
