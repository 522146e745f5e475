#pragma once

/// Ray-polygon intersection, four edges at a time, by the rule of ray_edge.h. Polygons
/// are those of Solids: closed by their first corner, padded by Solids::kPad.
///
/// In: a ray from p along the unit vector d; a polygon. [m]
/// Out: the distance to the polygon, kMiss or NaN if it is missed.
/// Cost: that of ray_edge.h for each four edges; entry() has one division for all of a convex polygon.

#include <algorithm>

#include "playhouse/bodies/ray_edge.h"
#include "playhouse/bodies/space.h"

namespace playhouse::bodies {

static_assert(Solids::kPad >= kConvexCorners);

/// Four corners from `corner` on, relative to p, in the
/// order 0, 2, 1, 3: loading them that way saves a shuffle.
struct Corners {
  static constexpr simd::Double4 kNumber = {0, 2, 1, 3};
  simd::Double4 u, v;

  PLAYHOUSE_INLINE Corners(const Vec2* corner, Vec2 p) {
    simd::Double4 first, second;
    std::memcpy(&first, corner, sizeof first);
    std::memcpy(&second, corner + 2, sizeof second);
    u = __builtin_shufflevector(first, second, 0, 4, 2, 6) - p.x;
    v = __builtin_shufflevector(first, second, 1, 5, 3, 7) - p.y;
  }
  /// Stores numbers of the corners in polygon order.
  PLAYHOUSE_INLINE static void store_in_order(const simd::Double4& numbers, double* to) {
    simd::store(to, simd::Double4(__builtin_shufflevector(numbers, numbers, 0, 2, 1, 3)));
  }
};

/// The nearest hit of the ray from p along d among all edges, scalar.
[[gnu::noinline]] inline double polygon_hit_alone(const Vec2* polygon, std::size_t corners, Vec2 p, Vec2 d) {
  double first = kMiss;
  for (std::size_t i = 0; i < corners; ++i)
    first = std::min(first, edge_hit(polygon[i] - p, polygon[i + 1] - p, d));
  return first;
}

/// The same in vectors, inlined; falls back to the scalar version if any edge is seen edge-on.
PLAYHOUSE_INLINE double polygon_hit_here(const Vec2* polygon, std::size_t corners, Vec2 p, Vec2 d) {
  const simd::Double4 number = Corners::kNumber;
  simd::Double4 best = {kMiss, kMiss, kMiss, kMiss};
  simd::Mask4 edge_on = {};
  for (std::size_t i = 0; i < corners; i += simd::kFour) {
    const Corners w0(polygon + i, p), w1(polygon + i + 1, p);
    const Distance<double, simd::Double4> met(d.x, d.y, w0.u, w0.v, w1.u, w1.v);
    const auto is_edge = number < static_cast<double>(corners - i);
    edge_on |= met.edge_on & is_edge;
    best = ((met.t < best) & is_edge) ? met.t : best;
  }
  if (simd::any(edge_on)) return polygon_hit_alone(polygon, corners, p, d);
  return std::min(std::min(best[0], best[1]), std::min(best[2], best[3]));
}

/// The distance at which the ray enters a convex polygon: negative if behind p or by an edge
/// seen edge-on, NaN if it misses. A ray enters by at most one edge, so one division serves all.
PLAYHOUSE_INLINE double entry(const Vec2* polygon, std::size_t corners, Vec2 p, Vec2 d) {
  const simd::Double4 number = Corners::kNumber, none = {0, 0, 0, 0};
  simd::Double4 areas = none, slopes = none;
  for (std::size_t i = 0; i < corners; i += simd::kFour) {
    const Corners w0(polygon + i, p), w1(polygon + i + 1, p);
    const Crossing<simd::Double4> ends({d.x, d.y, w0.u, w0.v}, {d.x, d.y, w1.u, w1.v});
    simd::Double4 area;
    cross(w0.u, w0.v, w1.u, w1.v, area);
    const auto enters = ends.enters & (number < static_cast<double>(corners - i));
    areas += enters ? area : none;
    slopes += enters ? ends.slope : none;
  }
  const double area = (areas[0] + areas[1]) + (areas[2] + areas[3]),
               slope = (slopes[0] + slopes[1]) + (slopes[2] + slopes[3]);
  const simd::Double4 only = {slope}, t = simd::Double4{area} / only;  // branch-free: hits are unpredictable
  return (((only < 0) & (only > -kEdgeOn)) ? -1 : t)[0];
}

/// entry() for known entry edges from (x0, y0) to (x1, y1), relative to the origins of the rays along (dx,
/// dy).
PLAYHOUSE_INLINE void enter(const simd::Double4& x0, const simd::Double4& y0, const simd::Double4& x1,
                            const simd::Double4& y1, const simd::Double4& dx, const simd::Double4& dy,
                            simd::Double4& t) {
  const Crossing<simd::Double4> ends({dx, dy, x0, y0}, {dx, dy, x1, y1});
  simd::Double4 area;
  cross(x0, y0, x1, y1, area);
  t = (area + 0.0) / ends.slope;  // +0 of -0, as a sum gives
  t = ends.slope > -kEdgeOn ? -1 : t;
}

/// Distance at which the ray from p along d hits a movable body; kMiss or NaN if it misses.
PLAYHOUSE_INLINE double body_hit_here(const Vec2* polygon, std::size_t corners, bool convex, Vec2 p, Vec2 d) {
  const double t = entry(polygon, corners, p, d);
  return t < 0 || !convex ? polygon_hit_here(polygon, corners, p, d) : t;
}

/// The same, out of line, for cold paths.
[[gnu::noinline]] inline double body_hit(const Vec2* polygon, std::size_t corners, bool convex, Vec2 p,
                                         Vec2 d) {
  return body_hit_here(polygon, corners, convex, p, d);
}

}  // namespace playhouse::bodies
