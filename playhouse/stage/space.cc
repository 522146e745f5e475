#include "playhouse/stage/space.h"

#include <algorithm>
#include <cstring>

#include "playhouse/stage/vectors.h"

namespace playhouse::stage {
namespace {

static_assert(Solids::kSpare >= kFour);

/// Four corners from `corner` on, relative to p.
struct Corners {
  Four u, v;

  __attribute__((always_inline)) Corners(const Vec2* corner, Vec2 p) {
    Four first, second;
    std::memcpy(&first, corner, sizeof first);
    std::memcpy(&second, corner + 2, sizeof second);
    u = __builtin_shufflevector(first, second, 0, 2, 4, 6) - p.x;
    v = __builtin_shufflevector(first, second, 1, 3, 5, 7) - p.y;
  }
};

}  // namespace

PLAYHOUSE_VECTORS double polygon_hit(const Vec2* polygon, std::size_t corners, Vec2 p, Vec2 d) {
  const Four lane = {0, 1, 2, 3};
  Four best = {kMiss, kMiss, kMiss, kMiss};
  for (std::size_t i = 0; i < corners; i += kFour) {
    const Corners w0(polygon + i, p), w1(polygon + i + 1, p);
    const Four s0 = d.x * w0.v - d.y * w0.u, s1 = d.x * w1.v - d.y * w1.u;
    const Four t = (w0.u * w1.v - w0.v * w1.u) / (s1 - s0);
    const auto met = ((s0 <= 0) & (s1 >= 0)) | ((s0 >= 0) & (s1 <= 0));
    best = (met & (t >= 0) & (t < best) & (lane < static_cast<double>(corners - i))) ? t : best;
  }
  return std::min(std::min(best[0], best[1]), std::min(best[2], best[3]));
}

}  // namespace playhouse::stage
