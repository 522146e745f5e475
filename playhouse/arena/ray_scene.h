#pragma once

/// RayScene: nearest ray-triangle intersections, by Embree. The BVH of static triangles
/// and that of each shape is built once, that of instances whenever they move.
///
/// In: static triangles in W, shapes, poses of instances, owners.
///
/// Out: for each ray the hit distance, the owner of the hit, and the angle of incidence.
///
/// Cost: set_fixed() 0.4 us per triangle, commit() 0.5 us per instance, 60 ns per
/// ray in narrow batches among 200,000 triangles and 1,000 instances (arena_bench).
///
/// Source: Wald et al., "Embree: a kernel framework for efficient CPU ray tracing", 2014.
///
/// Thread: cast() from any number of threads at once; the rest from one.

#include <cstdint>
#include <memory>
#include <span>

#include "playhouse/arena/triangles.h"

namespace playhouse::arena {

/// The owner of a surface. Rays ignore surfaces of their own group.
struct Owner {
  std::uint32_t id = 0, group = 0;
};

/// A batch of up to kMost rays, as columns.
struct alignas(64) RayBatch {
  static constexpr std::size_t kMost = 16;
  static constexpr std::uint32_t kNobody = 0xffffffff;

  std::size_t count = 0;
  std::uint32_t group = kNobody;  // of the observer
  bool is_narrow = false;         // coherent: common origin, directions within a few degrees: faster
  float px[kMost] = {}, py[kMost] = {}, pz[kMost] = {};  // origins  [m, in W]
  float dx[kMost] = {}, dy[kMost] = {}, dz[kMost] = {};  // unit vectors
  float inside[kMost] = {};       // length that starts inside solids of their group: a hint, or 0  [m]
  float range[kMost] = {};        // in: largest distance; out: distance of the hit  [m]
  std::uint32_t met[kMost] = {};  // out: owner id of the hit, or kNobody
  float facing[kMost] = {};       // out: cosine of the angle between ray and normal
  bool wants_normals = false;     // request normals
  float nx[kMost] = {}, ny[kMost] = {}, nz[kMost] = {};  // out: unit normal at the hit  [in W]
};

class RayScene {
 public:
  RayScene();
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// Replaces the static triangles; `owners` has one entry for each of `fixed`.
  void set_fixed(std::span<const Triangles> fixed, std::span<const Owner> owners);
  /// Adds a shape for instances; shapes are numbered from 0.
  std::uint32_t add_shape(const Triangles& triangles);
  struct Instance {
    std::uint32_t shape = 0;
    Owner owner;
  };
  /// Replaces all instances, placed at the origin.
  void set_instances(std::span<const Instance> instances);
  void place(std::uint32_t instance, const geom::Vec3& p, const geom::Quaternion& q);
  /// Rebuilds the top-level BVH. To be called after any change and before cast().
  void commit();

  void cast(RayBatch& rays) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace playhouse::arena
