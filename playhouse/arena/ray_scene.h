#pragma once

/// RayScene: which triangle a ray meets first, by Embree. What stands still is indexed once, each shape once,
/// and where the instances of shapes are whenever it changes.
///
/// In: triangles in W that stand still, shapes, and where instances of them are; whose they are.
///
/// Out: for each ray how far it comes, the owner of what it meets, and at which angle.
///
/// Cost: set_fixed() 0.4 us for a triangle, commit() 0.5 us for an instance; a ray 60 ns in narrow batches
/// among 200,000 triangles and 1,000 instances (arena_bench).
///
/// Source: Wald et al., "Embree: a kernel framework for efficient CPU ray tracing", 2014.
///
/// Thread: cast() from any number of threads at once; the rest from one.

#include <cstdint>
#include <memory>
#include <span>

#include "playhouse/arena/triangles.h"

namespace playhouse::arena {

/// Whose a surface is. Rays pass through those of their own group.
struct Owner {
  std::uint32_t id = 0, group = 0;
};

/// Up to kMost rays that are alike, as columns.
struct alignas(64) RayBatch {
  static constexpr std::size_t kMost = 16;
  static constexpr std::uint32_t kNobody = 0xffffffff;

  std::size_t count = 0;
  std::uint32_t group = kNobody;  // of who looks
  bool is_narrow = false;         // they begin at one place and differ by a few degrees: faster
  float px[kMost] = {}, py[kMost] = {}, pz[kMost] = {};  // where they begin  [m, in W]
  float dx[kMost] = {}, dy[kMost] = {}, dz[kMost] = {};  // unit vectors
  float inside[kMost] = {};       // for so long they are within solids of their group: a hint, or 0  [m]
  float range[kMost] = {};        // how far they go at most; then how far they came  [m]
  std::uint32_t met[kMost] = {};  // out: the id of an owner, or kNobody
  float facing[kMost] = {};       // out: cosine of the angle between a ray and the normal of what it met
  bool wants_normals = false;     // whether these are told
  float nx[kMost] = {}, ny[kMost] = {}, nz[kMost] = {};  // out: a unit normal of what it met  [in W]
};

class RayScene {
 public:
  RayScene();
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// Replaces what stands still; `owners` has one for each.
  void set_fixed(std::span<const Triangles> fixed, std::span<const Owner> owners);
  /// A shape that instances may have; they are numbered from 0.
  std::uint32_t add_shape(const Triangles& triangles);
  struct Instance {
    std::uint32_t shape = 0;
    Owner owner;
  };
  /// Replaces all instances; they are at the origin.
  void set_instances(std::span<const Instance> instances);
  void place(std::uint32_t instance, const geom::Vec3& p, const geom::Quaternion& q);
  /// To be called after any of these and before cast().
  void commit();

  void cast(RayBatch& rays) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace playhouse::arena
