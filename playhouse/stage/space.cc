#include "playhouse/stage/space.h"

#include <algorithm>
#include <bit>

#include "playhouse/stage/vectors.h"

namespace playhouse::stage {
namespace {

constexpr std::size_t kCorners = 32;

/// Bit i: corner i is to the right of the ray (or on it, with a negative zero).
PLAYHOUSE_VECTORS std::uint64_t corners_right(const Vec2* corner, std::size_t count, Vec2 p, Vec2 d,
                                              double* side) {
  for (std::size_t i = 0; i < count; ++i) side[i] = d.x * (corner[i].y - p.y) - d.y * (corner[i].x - p.x);
  std::uint64_t right = 0;
  for (std::uint64_t i = 0; i < count; ++i) right |= (std::bit_cast<std::uint64_t>(side[i]) >> 63) << i;
  return right;
}

}  // namespace

double polygon_hit(std::span<const Vec2> polygon, Vec2 p, Vec2 d) {
  double best = kMiss;
  const std::size_t corners = polygon.size();
  if (corners > kCorners) {
    for (std::size_t i = 0; i < corners; ++i)
      best = std::min(best, edge_hit(polygon[i] - p, polygon[i + 1 < corners ? i + 1 : 0] - p, d));
    return best;
  }
  // The ray meets the edges whose ends are on different sides of it.
  double side[kCorners];
  const std::uint64_t right = corners_right(polygon.data(), corners, p, d, side);
  const std::uint64_t next_right = (right >> 1) | ((right & 1) << (corners - 1));
  for (std::uint64_t crossed = right ^ next_right; crossed != 0; crossed &= crossed - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(crossed));
    const std::size_t j = i + 1 < corners ? i + 1 : 0;
    const double t = geom::cross(polygon[i] - p, polygon[j] - p) / (side[j] - side[i]);
    if (t >= 0 && t < best) best = t;
  }
  return best;
}

}  // namespace playhouse::stage
