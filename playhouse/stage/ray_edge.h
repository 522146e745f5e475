#pragma once

/// Where a ray meets an edge: the only place where this is worked out, for one ray and one edge or for four
/// of either at once (Number is double or Four). All ways to find what a ray hits end here, so that they give
/// the same bits.
///
/// In: the ray's unit vector d; the ends w0 and w1 of the edge from where the ray begins.              [m]
/// Out: the distance along the ray, kMiss if it does not meet the edge; of several edges, the first (below).
/// Cost: 10 multiplications and subtractions and a division; a body that is looked at from outside or an edge
///   that many rays share needs less.
/// Source: Cramer's rule. The side of a corner is a difference of two rounded products and so right or 0,
///   never wrong (Kahan); counting 0 as one of the sides is the simulation of simplicity (Edelsbrunner and
///   Mücke 1990).
///
/// The rule:
/// - A corner on the line of the ray counts as being on its right. So a ray slips through no outline where
///   two edges meet; an edge along the ray is not met, but the one that ends where it begins is, if it comes
///   from the left.
/// - A ray that begins on an edge meets it, at 0, whichever way it goes.
/// - An edge that is less than kEdgeOn across, as the ray sees it, is met at its nearer end: the quotient of
///   two numbers that are rounding might be any distance.
/// - A convex body of a tree that moves is met where the ray enters it, if that is ahead. All else is met at
///   the first of its edges, from whichever side: outlines that stand still may be rooms.
/// - What is within another body that it is fixed to (enclosure.h) is not met, also by a ray that begins
/// there.
/// - Of edges at the same distance, that of the solid with the lower row comes first. What is at the very end
///   of the range is not met.

#include <algorithm>

#include "playhouse/geom/pose.h"
#include "playhouse/stage/vectors.h"

namespace playhouse::stage {

inline constexpr double kMiss = 1e300;
inline constexpr double kEdgeOn = 1e-9;  // m
inline constexpr double kNoSolid = -1;
/// A row of Solids, as a number that is chosen as distances are; kNoSolid where nothing was met.
constexpr double number_of(std::uint32_t row) {
  return static_cast<double>(row);
}
constexpr std::uint32_t row_of(double solid) {
  return static_cast<std::uint32_t>(solid);
}

template <typename First, typename Second, typename Number>
PLAYHOUSE_INLINE void cross(const First& x0, const First& y0, const Second& x1, const Second& y1,
                            Number& out) {
  out = x0 * y1 - y0 * x1;
}

/// On which side of a ray a corner is.
template <typename Number>
struct Side {
  Number left;  // m; 0 counts as the right

  Side() = default;
  template <typename Direction, typename Corner>
  PLAYHOUSE_INLINE Side(const Direction& dx, const Direction& dy, const Corner& x, const Corner& y) {
    cross(dx, dy, x, y, left);
  }
};

/// How a ray and an edge cross, by the sides of the ends of the edge.
template <typename Number>
struct Crossing {
  Number slope;                           // m from w0 to w1, to the left
  decltype(Number() > Number()) crosses;  // the ends are on different sides
  decltype(Number() > Number()) enters;   // into the outline of which the edge is a part, if that is solid

  PLAYHOUSE_INLINE Crossing(const Side<Number>& w0, const Side<Number>& w1)
      : slope(w1.left - w0.left),
        crosses((w0.left > 0) ^ (w1.left > 0)),
        enters((w0.left > 0) & (w1.left <= 0)) {}
};

/// The distance at which a ray meets an edge.
template <typename Direction, typename Corner>
struct Distance {
  using Number = decltype(Direction() * Corner());
  Number t;                               // kMiss also where edge_on
  decltype(Number() > Number()) edge_on;  // it meets the edge where along_edge() says

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

/// Where a ray meets an edge that it crosses and sees edge-on.
inline double along_edge(geom::Vec2 d, geom::Vec2 w0, geom::Vec2 w1) {
  const double t0 = geom::dot(d, w0), t1 = geom::dot(d, w1);
  return std::max(t0, t1) < 0 ? kMiss : std::max(0.0, std::min(t0, t1));
}

/// One ray and one edge.
inline double edge_hit(geom::Vec2 w0, geom::Vec2 w1, geom::Vec2 d) {
  const Distance<double, double> met(d.x, d.y, w0.x, w0.y, w1.x, w1.y);
  return met.edge_on ? along_edge(d, w0, w1) : met.t;
}

/// Keeps the first of what is known, a range and a solid, and a solid at distance t.
template <typename Number>
PLAYHOUSE_INLINE void keep_first(const Number& t, const Number& row, Number& range, Number& solid) {
  const auto first = (t < range) | ((t == range) & (row < solid));
  range = t < range ? t : range;
  solid = first ? row : solid;
}

/// The same for one ray, without branches: hits are unpredictable.
PLAYHOUSE_INLINE void keep_first_alone(double t, double row, double& range, double& solid) {
  Two ranges = {range}, solids = {solid};
  keep_first(Two{t}, Two{row}, ranges, solids);
  range = ranges[0];
  solid = solids[0];
}

}  // namespace playhouse::stage
