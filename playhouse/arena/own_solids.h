#pragma once

/// How far the rays of a sensor go inside solids of the tree that carries it: they may begin where they come
/// out. Frame: B the tree's top.

#include <map>
#include <span>
#include <vector>

#include "playhouse/arena/lidar_beams.h"
#include "playhouse/stage/bodies.h"

namespace playhouse::arena {

/// What is within an odd number of outlines, between two heights.
struct OwnSolid {
  std::vector<std::vector<geom::Vec2>> outlines;  // m, in B
  double z_low = 0, z_high = 0;                   // m
};

/// From p along the unit vector d: how far it is solid without a gap.  [m]
double inside_of(std::span<const OwnSolid> solids, const geom::Vec3& p, const geom::Vec3& d);

/// The same for all rays of rangers. Those in trees that are alike are looked at once.
class OwnSolids {
 public:
  /// Of the ranger that is row `model`, whose tree has the solids [first, last); valid as long as this.
  /// Nothing where parts of the tree move against each other or are meshes. Cost: a test for each ray and
  /// edge, the first time. [m]
  std::span<const float> inside(const world::World& world, const stage::Solids& solids, std::uint32_t model,
                                const LidarBeams& beams, std::size_t first, std::size_t last);

 private:
  std::map<std::vector<double>, std::vector<float>> known_;  // by what makes trees alike
};

}  // namespace playhouse::arena
