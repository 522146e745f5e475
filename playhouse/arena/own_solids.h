#pragma once

/// How far the rays of a sensor start inside solids of their own tree, so
/// that they can be cast from where they exit. Frame: B the tree's root.

#include <map>
#include <span>
#include <vector>

#include "playhouse/arena/lidar_beams.h"
#include "playhouse/stage/bodies.h"

namespace playhouse::arena {

/// A prism: the even-odd inside of outlines, between two heights.
struct OwnSolid {
  std::vector<std::vector<geom::Vec2>> outlines;  // m, in B
  double z_low = 0, z_high = 0;                   // m
};

/// Length of the solid interval that starts at p along the unit vector d.  [m]
double inside_of(std::span<const OwnSolid> solids, const geom::Vec3& p, const geom::Vec3& d);

/// The same for all rays of rangers, cached by equal trees.
class OwnSolids {
 public:
  /// Of the ranger at row `model`, whose tree has the solids [first, last);
  /// valid while this lives. Empty if the tree is articulated or has meshes.
  /// Cost: a test for each pair of ray and edge, the first time. [m]
  std::span<const float> inside(const world::World& world, const stage::Solids& solids, std::uint32_t model,
                                const LidarBeams& beams, std::size_t first, std::size_t last);

 private:
  std::map<std::vector<double>, std::vector<float>> known_;  // key: all that distinguishes trees
};

}  // namespace playhouse::arena
