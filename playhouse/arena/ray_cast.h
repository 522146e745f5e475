#pragma once

/// Nearest intersections of rays from one point with triangles.
///
/// Rays of a scanner have their origin in common, and their neighbours nearly the direction. Up to 128 of
/// them are a fan, which is tested as a whole: its pyramid against the sixteen boxes of a node at once; a box
/// from the stack against sixteen groups of the rays and what those have hit already; the triangles of a leaf
/// against the sides of each block of sixteen rays, and those between them against its rays. A batch that
/// spans more than a fan should is cut in halves.
///
/// In: the index of triangles, rays.
///
/// Out: of each ray the distance of the nearest hit, its owner, normal and angle. No ray passes between
/// triangles that have corners in common: they reach as far beyond their edges as edge functions are rounded,
/// 0.4 urad. The same bits with every instruction set (sixteen_plain.inc, sixteen_avx2.inc,
/// sixteen_avx512.inc).
///
/// Cost: among 200,000 triangles and 1,000 boxes 40 ns per ray of 1,800 beams in a turn, 170 ns of 360
/// (arena_bench).
///
/// Source: Reshetov, Soupikov, Hurley, "Multi-level ray tracing algorithm", 2005 (pyramids); Davidovic,
/// Engelhardt, Georgiev, Slusallek, Dachsbacher, "3D rasterization: a bridge between rasterization and ray
/// casting", 2012 (edge functions of rays from one point).

#include <array>
#include <vector>

#include "playhouse/arena/bvh.h"
#include "playhouse/arena/ray_batch.h"
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
  std::array<float, 9> R_WS = {1, 0, 0, 0, 1, 0, 0, 0, 1};  // by columns
  std::array<float, 3> p_WS = {};                           // m
};

struct RayIndex {
  TriangleIndex fixed;  // in W
  std::vector<Owner> fixed_owners;
  std::vector<TriangleIndex> shapes;  // each in its own frame S
  std::vector<ShapeInstance> instances;
  Bvh placed;  // of instances, a leaf each

  /// Builds `placed`; to be called after instances have moved.
  void place_instances();
};

void cast_rays(const RayIndex& index, RayBatch& rays);

}  // namespace playhouse::arena
