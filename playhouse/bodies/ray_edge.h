#pragma once

/// Ray-edge intersection: the only implementation, for one ray and
/// one edge or for four of either at once (Number is double or
/// Double4). All ray casts use it, so that they give the same bits.
///
/// In: the ray's unit vector d; the ends w0 and w1 of the edge relative to the ray's origin.           [m]
/// Out: the distance along the ray, kMiss if it misses the edge; the nearest of several edges.
/// Cost: 10 multiplications and subtractions and a division; a body seen from outside or an edge shared by
///   many rays needs less.
/// Source: Cramer's rule. The side of a corner is a difference of two rounded products: its sign is right or
///   it is 0, never wrong (Kahan); counting 0 as one of the sides is simulation of simplicity (Edelsbrunner
///   and Mücke 1990).
///
/// Degenerate cases:
/// - A corner on the line of the ray counts as on its right, so a ray cannot leak through the corner of an
///   outline. An edge collinear with the ray is missed; the edge that ends where a collinear one begins is hit
///   if it comes from the left.
/// - A ray whose origin is on an edge hits it at 0, whatever its direction.
/// - An edge whose extent across the ray is less than kEdgeOn is hit at its nearer end: the quotient would be
///   rounding noise.
/// - A convex movable body is hit where the ray enters it, if that is ahead. All others are hit at the nearest
///   edge, from either side: a static outline may be a room.
/// - What is enclosed by another body of its tree (enclosure.h) is not hit, not even by a ray that starts inside
///   it.
/// - Ties in distance go to the solid with the lower row. A hit at exactly the ray's range is a miss.

#include <algorithm>

#include "playhouse/bodies/rows.h"
#include "playhouse/geom/pose.h"
#include "playhouse/simd/vectors.h"

namespace playhouse::bodies {

inline constexpr double kMiss = 1e300;
inline constexpr double kEdgeOn = 1e-9;  // m
inline constexpr double kNoSolid = -1;
/// A row of Solids as a double, so that it is selected by the same masks as distances; kNoSolid: no hit.
constexpr double number_of(SolidRow row) {
  return static_cast<double>(row.index);
}
constexpr SolidRow row_of(double solid) {
  return {static_cast<std::uint32_t>(solid)};
}

template <typename First, typename Second, typename Number>
PLAYHOUSE_INLINE void cross(const First& x0, const First& y0, const Second& x1, const Second& y1,
                            Number& out) {
  out = x0 * y1 - y0 * x1;
}

/// The side of a ray on which a corner lies.
template <typename Number>
struct Side {
  Number left;  // m, positive to the left; 0 counts as right

  Side() = default;
  template <typename Direction, typename Corner>
  PLAYHOUSE_INLINE Side(const Direction& dx, const Direction& dy, const Corner& x, const Corner& y) {
    cross(dx, dy, x, y, left);
  }
};

/// How a ray crosses an edge, by the sides of its ends.
template <typename Number>
struct Crossing {
  Number slope;                           // m: difference of the ends' sides
  decltype(Number() > Number()) crosses;  // the ends are on different sides
  decltype(Number() > Number()) enters;   // the crossing leads into the outline, if that is solid

  PLAYHOUSE_INLINE Crossing(const Side<Number>& w0, const Side<Number>& w1)
      : slope(w1.left - w0.left),
        crosses((w0.left > 0) ^ (w1.left > 0)),
        enters((w0.left > 0) & (w1.left <= 0)) {}
};

/// The distance at which a ray hits an edge.
template <typename Direction, typename Corner>
struct Distance {
  using Number = decltype(Direction() * Corner());
  Number t;                               // kMiss also where edge_on
  decltype(Number() > Number()) edge_on;  // seen edge-on: hit at along_edge()

  PLAYHOUSE_INLINE Distance(const Direction& dx, const Direction& dy, const Corner& x0, const Corner& y0,
                            const Corner& x1, const Corner& y1) {
    const Crossing<Number> ends({dx, dy, x0, y0}, {dx, dy, x1, y1});
    Number area;
    cross(x0, y0, x1, y1, area);
    t = area / ends.slope;
    edge_on = ends.crosses & (ends.slope * ends.slope < kEdgeOn * kEdgeOn);
    t = ((ends.crosses ^ edge_on) & (t >= 0)) ? t : kMiss;
  }
};

/// Hit distance of an edge that the ray crosses edge-on.
inline double along_edge(geom::Vec2 d, geom::Vec2 w0, geom::Vec2 w1) {
  const double t0 = geom::dot(d, w0), t1 = geom::dot(d, w1);
  return std::max(t0, t1) < 0 ? kMiss : std::max(0.0, std::min(t0, t1));
}

/// Scalar version.
inline double edge_hit(geom::Vec2 w0, geom::Vec2 w1, geom::Vec2 d) {
  const Distance<double, double> met(d.x, d.y, w0.x, w0.y, w1.x, w1.y);
  return met.edge_on ? along_edge(d, w0, w1) : met.t;
}

/// Keeps the nearer of two hits (range, solid) and (t, row); a tie goes to the lower row.
template <typename Number>
PLAYHOUSE_INLINE void keep_first(const Number& t, const Number& row, Number& range, Number& solid) {
  const auto first = (t < range) | ((t == range) & (row < solid));
  range = t < range ? t : range;
  solid = first ? row : solid;
}

/// The same for one ray, branch-free: hits are unpredictable.
PLAYHOUSE_INLINE void keep_first_alone(double t, double row, double& range, double& solid) {
  simd::Double2 ranges = {range}, solids = {solid};
  keep_first(simd::Double2{t}, simd::Double2{row}, ranges, solids);
  range = ranges[0];
  solid = solids[0];
}

}  // namespace playhouse::bodies
