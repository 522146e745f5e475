#pragma once

/// Space: every body and how to find those near a place; what the senses read. And one exact ray through it.

#include "playhouse/stage/bodies.h"
#include "playhouse/stage/disc_index.h"
#include "playhouse/stage/walls.h"

namespace playhouse::stage {

struct Space {
  const Solids& solids;
  const DiscIndex& index;  // the moving solids, each by disc_of(); row: of Solids
  const Walls& walls;      // the edges of the others
};

/// What circles about solids, and reaches, are widened by before they rule a hit out, so that rounding loses
/// none.  [m]
inline constexpr double kMargin = 1e-6;

/// A solid that moves as the index has it.
inline DiscIndex::Disc disc_of(const Solids& solids, std::size_t row) {
  const std::uint32_t vertex = solids.first_vertex[row];
  const std::uint32_t vertices = solids.first_vertex[row + 1] - vertex - 1;
  return {solids.center[row],
          solids.radius[row],
          solids.z_free(row),
          solids.z_max[row],
          static_cast<std::uint32_t>(row),
          solids.root[row],
          vertex,
          vertices,
          solids.first_corners[row - solids.fixed],
          static_cast<std::uint8_t>(solids.convex_corners(row)),
          solids.seen_by[row]};
}

struct Ray {
  Vec2 p, d;               // from p towards the unit vector d, in W
  double z_low = 0;        // m; what is at any height up to z_high is met
  double z_high = 0;       // m
  double range = 0;        // m
  Observers by = 0;        // whoever looks: solids that none of them sees are passed through
  std::uint32_t root = 0;  // so are models of this tree
  std::uint32_t also_root = world::ModelRow::kNone;  // and of this one
};

struct Hit {
  double range = 0;                              // m; the ray's range if nothing was met
  std::uint32_t solid = world::ModelRow::kNone;  // row of Solids, or kNone
};

/// What rays between these heights may meet.
inline bool at_height(const Solids& solids, std::size_t row, double z_low, double z_high) {
  return solids.z_free(row) <= z_high && z_low <= solids.z_max[row];
}
inline bool at_height(const Solids& solids, std::size_t row, double z) {
  return at_height(solids, row, z, z);
}

/// The first solid that the ray meets, by the rule of ray_edge.h.
Hit cast(const Space& space, const Ray& ray);

}  // namespace playhouse::stage
