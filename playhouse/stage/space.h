#pragma once

/// Space: every body and how to find those near a place; what the senses read. And one exact ray through it.

#include "playhouse/stage/bodies.h"
#include "playhouse/stage/disc_index.h"
#include "playhouse/stage/walls.h"

namespace playhouse::stage {

struct Space {
  const Solids& solids;
  const DiscIndex& index;  // the moving solids; row: of Solids
  const Walls& walls;      // the edges of the others
};

inline constexpr double kMiss = 1e300;
/// What circles about solids are widened by before they rule a hit out, so that rounding loses none.  [m]
inline constexpr double kMargin = 1e-6;

/// Distance from the origin along the unit vector d to the segment w0-w1, ends included; kMiss if it is not
/// met or lies along d.
inline double edge_hit(Vec2 w0, Vec2 w1, Vec2 d) {
  const double s0 = geom::cross(d, w0), s1 = geom::cross(d, w1);
  if ((s0 < 0 && s1 < 0) || (s0 > 0 && s1 > 0) || s0 == s1) return kMiss;
  const double t = geom::cross(w0, w1) / (s1 - s0);
  return t >= 0 ? t : kMiss;
}

/// Distance from p along d to the outline of a polygon of Solids, from outside or inside; kMiss if it is not
/// met.
double polygon_hit(const Vec2* polygon, std::size_t corners, Vec2 p, Vec2 d);

struct Ray {
  Vec2 p, d;               // from p towards the unit vector d, in W
  double z = 0;            // m
  double range = 0;        // m
  std::uint32_t root = 0;  // models of this tree are passed through
};

struct Hit {
  double range = 0;  // m; the ray's range if nothing was met
  std::uint32_t solid = world::ModelRow::kNone;
};

inline bool at_height(const Solids& solids, std::size_t row, double z) {
  return solids.z_min[row] <= z && z <= solids.z_max[row];
}

/// The nearest solid that the ray meets and `sees(row)` accepts.
template <typename Sees>
Hit cast(const Space& space, const Ray& ray, const Sees& sees) {
  const Solids& solids = space.solids;
  Hit hit{ray.range, world::ModelRow::kNone};
  const auto meet = [&](double t, std::uint32_t row) {
    if (t >= hit.range || solids.root[row] == ray.root || !at_height(solids, row, ray.z) || !sees(row))
      return;
    hit = {t, row};
  };
  space.walls.along(ray.p, ray.d, &hit.range, [&](const Walls::Edge& edge) {
    meet(edge_hit(edge.a - ray.p, edge.b - ray.p, ray.d), edge.solid);
  });
  const double half = 0.5 * hit.range;
  space.index.near(ray.p + half * ray.d, half, ray.z, ray.z, [&](const DiscIndex::Disc& disc) {
    const Vec2 to_disc = disc.center - ray.p;
    if (std::fabs(geom::cross(ray.d, to_disc)) > disc.radius + kMargin) return;
    meet(polygon_hit(solids.p.data() + disc.first_vertex, disc.vertices, ray.p, ray.d), disc.row);
  });
  return hit;
}

}  // namespace playhouse::stage
