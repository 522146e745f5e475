#pragma once

/// Decomposition of areas between closed outlines into trapezoids
/// with horizontal sides, for pictures and meshes. Pure functions.

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "playhouse/geom/pose.h"

namespace playhouse::geom {

/// A closed polygon; the last point is joined to the first.
using Outline = std::span<const Vec2>;

/// Between y_low and y_high, from a slanted side to another; a horizontal side may be a point.
struct Trapezoid {
  double y_low = 0, y_high = 0;
  double left_low = 0, left_high = 0, right_low = 0, right_high = 0;  // x of the sides at y_low and y_high
};

/// The even-odd inside of the outlines, without overlaps. Sides that cross
/// between the heights of two corners are ordered there as at half height. Cost:
/// O(n log n + n k) for n corners, k sides crossing the height of a corner.
std::vector<Trapezoid> trapezoids(std::span<const Outline> outlines);

/// Scan conversion: calls visit(line, left, right) for the lines y = line + 0.5, from
/// `first` to `last` - 1, that intersect a trapezoid, with the x range of the intersection.
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
