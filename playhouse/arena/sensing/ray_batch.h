#pragma once

/// Rays from one point, cast together (ray_scene.h). Values.

#include <cstddef>
#include <cstdint>

#include "playhouse/geom/orientation.h"

namespace playhouse::arena {

/// The owner of a surface. Rays ignore surfaces of their own group.
struct Owner {
  std::uint32_t id = 0, group = 0;
};

/// Up to kMost rays from p, as columns. Fastest if neighbours in
/// the batch are neighbours in direction, as those of a ring are.
struct alignas(64) RayBatch {
  static constexpr std::size_t kMost = 128;
  static constexpr std::uint32_t kNobody = 0xffffffff;

  std::size_t count = 0;
  std::uint32_t group = kNobody;                         // of the sensor
  geom::Vec3 p;                                          // origin  [m, in W]
  float dx[kMost] = {}, dy[kMost] = {}, dz[kMost] = {};  // unit vectors
  float range[kMost] = {};        // in: largest distance; out: distance of the hit  [m]
  std::uint32_t met[kMost] = {};  // out: owner id of the hit, or kNobody
  float facing[kMost] = {};       // out: cosine of the angle between ray and normal, 0 if nothing is hit
  bool wants_normals = false;     // request normals
  float nx[kMost] = {}, ny[kMost] = {},
        nz[kMost] = {};  // out: unit normal at the hit, on either side  [in W]

  void set_ray(std::size_t k, const geom::Vec3& d, float range_max) {
    dx[k] = static_cast<float>(d.x), dy[k] = static_cast<float>(d.y), dz[k] = static_cast<float>(d.z);
    range[k] = range_max;
  }
};

}  // namespace playhouse::arena
