#pragma once

/// RayIndex: what rays are cast against. Triangles that stand still are in one hierarchy;
/// a shape has one of its own, and instances of shapes are in another.
///
/// In: triangles, the poses of instances.
///
/// Out: hierarchies of boxes, and the triangles of each leaf as columns.
///
/// Cost: 0.45 us per triangle, 0.25 us per instance (arena_bench).
///
/// Source: bvh.h; a hierarchy of instances over one of each shape: Wald, Benthin, Slusallek, "Distributed
/// interactive ray tracing of dynamic scenes", 2003.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/arena/sensing/bvh.h"
#include "playhouse/arena/sensing/ray_batch.h"
#include "playhouse/arena/triangles.h"

namespace playhouse::arena {

/// The triangles of a leaf, as columns.
struct alignas(64) TriangleBlock {
  static constexpr std::size_t kMost = 16;
  float p[3][3][kMost] = {};        // coordinates of each corner  [m]
  std::uint32_t owner[kMost] = {};  // row of RayIndex::fixed_owners; unused in shapes
  std::uint32_t count = 0;
};

struct TriangleIndex {
  Bvh bvh;
  std::vector<TriangleBlock> blocks;  // one for each leaf
};

/// `owner` has one entry for each triangle, or is empty.
TriangleIndex triangle_index_of(const Triangles& triangles, std::span<const std::uint32_t> owner);

/// A shape at a pose.
struct ShapeInstance {
  std::uint32_t shape = 0;
  Owner owner;
  std::array<float, 9> R_FS = {1, 0, 0, 0, 1, 0, 0, 0, 1};  // by columns
  std::array<float, 3> p_FS = {};                           // m
};

/// Coordinates are single precision in F, whose axes are those of W and whose origin
/// is near what stands still: worlds far from the origin of W lose none.
struct RayIndex {
  geom::Vec3 p_WF;      // m
  TriangleIndex fixed;  // in F
  std::vector<Owner> fixed_owners;
  std::vector<TriangleIndex> shapes;  // each in its own frame S
  std::vector<ShapeInstance> instances;
  Bvh placed;  // of instances, a leaf each

  /// A point of W in F.
  void put(const geom::Vec3& p_W, float* p_F) const {
    const geom::Vec3 p = p_W - p_WF;
    p_F[0] = static_cast<float>(p.x), p_F[1] = static_cast<float>(p.y), p_F[2] = static_cast<float>(p.z);
  }
  /// Builds `placed`; to be called after instances have moved.
  void place_instances();
};

}  // namespace playhouse::arena
