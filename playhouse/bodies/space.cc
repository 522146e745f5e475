#include "playhouse/bodies/space.h"

#include <cmath>

#include "playhouse/bodies/polygon_hit.h"

namespace playhouse::bodies {

Hit cast(const Space& space, const Ray& ray) {
  const Solids& solids = space.solids;
  double range = ray.range, solid = kNoSolid;
  const auto is_seen = [&](SolidRow row) {
    return (solids.seen_by[row] & ray.by) != 0 && solids.root[row] != ray.root &&
           solids.root[row] != ray.also_root && at_height(solids, row, ray.z_low, ray.z_high);
  };
  space.walls.along(ray.p, ray.d, &range, [&](const Walls::Edge& edge) {
    if (!is_seen(edge.solid)) return;
    keep_first(edge_hit(edge.a - ray.p, edge.b - ray.p, ray.d), number_of(edge.solid), range, solid);
  });
  const double half = 0.5 * range;
  space.index.near(
      ray.p + half * ray.d, half + kMargin, ray.z_low, ray.z_high, [&](const DiscIndex::Disc& disc) {
        const Vec2 to_disc = disc.center - ray.p;
        if (std::fabs(geom::cross(ray.d, to_disc)) > disc.radius + kMargin || !is_seen(disc.solid())) return;
        const double t = simd::in_vectors<body_hit_here>(solids.p.from(disc.first_vertex), disc.vertices,
                                                         disc.convex != 0, ray.p, ray.d);
        keep_first(t, number_of(disc.solid()), range, solid);
      });
  if (solid == kNoSolid) return {range, {}};
  return {range, row_of(solid)};
}

}  // namespace playhouse::bodies
