#pragma once

/// Where a ray meets the outline of a polygon, four edges at a time.

#include <algorithm>

#include "playhouse/stage/space.h"
#include "playhouse/stage/vectors.h"

namespace playhouse::stage {

static_assert(Solids::kSpare >= kFour);

/// Four corners from `corner` on, relative to p: the first, the third, the second, the fourth, which spares
/// the processor putting them in order.
struct Corners {
  static constexpr Four kNumber = {0, 2, 1, 3};
  Four u, v;

  PLAYHOUSE_INLINE Corners(const Vec2* corner, Vec2 p) {
    Four first, second;
    std::memcpy(&first, corner, sizeof first);
    std::memcpy(&second, corner + 2, sizeof second);
    u = __builtin_shufflevector(first, second, 0, 4, 2, 6) - p.x;
    v = __builtin_shufflevector(first, second, 1, 5, 3, 7) - p.y;
  }
};

/// polygon_hit(), as a part of the caller.
PLAYHOUSE_INLINE double polygon_hit_here(const Vec2* polygon, std::size_t corners, Vec2 p, Vec2 d) {
  const Four number = Corners::kNumber;
  Four best = {kMiss, kMiss, kMiss, kMiss};
  for (std::size_t i = 0; i < corners; i += kFour) {
    const Corners w0(polygon + i, p), w1(polygon + i + 1, p);
    const Four s0 = d.x * w0.v - d.y * w0.u, s1 = d.x * w1.v - d.y * w1.u;
    const Four t = (w0.u * w1.v - w0.v * w1.u) / (s1 - s0);
    best = ((s0 * s1 <= 0) & (t >= 0) & (t < best) & (number < static_cast<double>(corners - i))) ? t : best;
  }
  return std::min(std::min(best[0], best[1]), std::min(best[2], best[3]));
}

/// Where the ray enters a convex polygon: below 0 if that is behind p, not a number if it passes by. Only one
/// edge has its first corner left of the ray and its second not, which spares the other divisions.
PLAYHOUSE_INLINE double entry(const Vec2* polygon, std::size_t corners, Vec2 p, Vec2 d) {
  const Four number = Corners::kNumber, none = {0, 0, 0, 0};
  Four area = none, slope = none;
  for (std::size_t i = 0; i < corners; i += kFour) {
    const Corners w0(polygon + i, p), w1(polygon + i + 1, p);
    const Four s0 = d.x * w0.v - d.y * w0.u, s1 = d.x * w1.v - d.y * w1.u;
    const auto enters = (s0 > 0) & (s1 <= 0) & (number < static_cast<double>(corners - i));
    area += enters ? w0.u * w1.v - w0.v * w1.u : none;
    slope += enters ? s1 - s0 : none;
  }
  return ((area[0] + area[1]) + (area[2] + area[3])) / ((slope[0] + slope[1]) + (slope[2] + slope[3]));
}

}  // namespace playhouse::stage
