#pragma once

/// Areas between closed outlines, cut into trapezoids with level sides: what pictures and meshes are made of.
/// Pure functions.

#include <algorithm>
#include <cmath>
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

/// Calls visit(line, left, right) for the level lines y = line + 0.5, from `first` to `last` - 1, that go
/// through a trapezoid, with the x at which they enter and leave it: how pictures are filled.
template <typename Visit>
void each_line(const Trapezoid& t, int first, int last, const Visit& visit) {
  const double from = std::max(static_cast<double>(first), std::ceil(t.y_low - 0.5));
  for (double line = from; line < last && line + 0.5 < t.y_high; ++line) {
    const double share = (line + 0.5 - t.y_low) / (t.y_high - t.y_low);
    visit(static_cast<int>(line), t.left_low + share * (t.left_high - t.left_low),
          t.right_low + share * (t.right_high - t.right_low));
  }
}

}  // namespace playhouse::geom
