#include "playhouse/stage/space.h"

#include "playhouse/stage/polygon_hit.h"

namespace playhouse::stage {

double polygon_hit(const Vec2* polygon, std::size_t corners, Vec2 p, Vec2 d) {
  return in_vectors<polygon_hit_here>(polygon, corners, p, d);
}

}  // namespace playhouse::stage
