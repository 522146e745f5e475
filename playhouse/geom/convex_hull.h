#pragma once

#include <vector>

#include "playhouse/geom/pose.h"

namespace playhouse::geom {

/// The corners of the convex hull of points, counter-clockwise; fewer than three where they are on one line.
/// Cost   sorts the points
/// Source Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979
std::vector<Vec2> convex_hull(std::vector<Vec2> points);

}  // namespace playhouse::geom
