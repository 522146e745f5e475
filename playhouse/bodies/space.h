#pragma once

/// Space: all bodies and their broad phase, read-only for the senses; and a single exact ray cast.
///
/// In: all solids, and a ray.
/// Out: where it ends.
/// Cost: the cells of wall along the ray; after that all movable bodies about what is left of it.

#include "playhouse/bodies/bodies.h"
#include "playhouse/bodies/disc_index.h"
#include "playhouse/bodies/walls.h"

namespace playhouse::bodies {

struct Space {
  const Solids& solids;
  const DiscIndex& index;  // the movable solids as disc_of(); row: of Solids
  const Walls& walls;      // the edges of the static ones
};

/// Inflation of bounding circles and reaches in culling
/// tests, so that rounding never culls a hit. [m]
inline constexpr double kMargin = 1e-6;

/// The entry of a movable solid in the index.
inline DiscIndex::Disc disc_of(const Solids& solids, SolidRow row) {
  return {solids.center[row],
          solids.radius[row],
          solids.z_free(row),
          solids.z_max[row],
          row.index,
          solids.root[row],
          solids.first_vertex[row],
          solids.corners_of(row),
          solids.first_corners[solids.place_of(row)],
          static_cast<std::uint8_t>(solids.convex_corners(row)),
          solids.seen_by[row]};
}

struct Ray {
  Vec2 p, d;                    // origin, unit vector in W
  double z_low = 0;             // m; heights z_low .. z_high are tested
  double z_high = 0;            // m
  double range = 0;             // m
  SeenByBits by = 0;            // solids that none of these sees are ignored
  world::ModelRow root{0};      // of the tree that is ignored
  world::ModelRow also_root{};  // another one
};

struct Hit {
  double range = 0;  // m; the ray's range if it missed
  SolidRow solid;    // none: it missed
};

/// True if rays within these heights can hit it.
inline bool at_height(const Solids& solids, SolidRow row, double z_low, double z_high) {
  return solids.z_free(row) <= z_high && z_low <= solids.z_max[row];
}
inline bool at_height(const Solids& solids, SolidRow row, double z) {
  return at_height(solids, row, z, z);
}

/// The nearest hit of the ray, by the rule of ray_edge.h.
Hit cast(const Space& space, const Ray& ray);

}  // namespace playhouse::bodies
