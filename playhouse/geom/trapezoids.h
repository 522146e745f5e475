#pragma once

/// Areas between closed outlines, cut into trapezoids with level sides: what pictures and meshes are made of.
/// Pure functions.

#include <span>
#include <vector>

#include "playhouse/geom/pose.h"

namespace playhouse::geom {

/// A closed outline, the last point joined to the first.
using Outline = std::span<const Vec2>;

/// Between y_low and y_high, from one slanted side to the other; one of its level sides may be a point.
struct Trapezoid {
  double y_low = 0, y_high = 0;
  double left_low = 0, left_high = 0, right_low = 0, right_high = 0;  // x of the sides at y_low and y_high
};

/// What is inside of an odd number of the outlines (even-odd rule), without overlaps. Sides that cross each
/// other between the heights of two corners count there in the order that they have halfway. Cost   O(n log n
/// + n k) for n corners, k sides at the height of one
std::vector<Trapezoid> trapezoids(std::span<const Outline> outlines);

}  // namespace playhouse::geom
