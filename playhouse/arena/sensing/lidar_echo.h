#pragma once

/// The echo of a lidar beam: from the first surface that returns enough light, after
/// any number of reflections and transmissions. Ranges are total path lengths.
///
/// In: the triangles, optical properties of surfaces, a beam and its first hit.
///
/// Out: the apparent range, and the returned share of the light.
///
/// Cost: a ray for each mirror and each face of a pane on the path, at most kBounces.
///
/// Source: optics.h.

#include <cstdint>
#include <span>

#include "playhouse/arena/sensing/optics.h"
#include "playhouse/arena/sensing/ray_scene.h"
#include "playhouse/world/world.h"

namespace playhouse::arena {

inline constexpr int kBounces = 4;
inline constexpr std::uint32_t kGround = 0xfffffffe;  // as a hit id: the plane z = 0

/// A hit of a beam.
struct Met {
  double range = 0;                      // m
  std::uint32_t id = RayBatch::kNobody;  // row of world::Models, or kGround
  double facing = 0;                     // cosine of the angle between the beam and the normal
  geom::Vec3 normal;                     // a unit vector, in W
};

/// The surfaces of a world's models.
struct Surfaces {
  const world::World& world;
  std::span<const Optics> optics;  // (models)
  Optics of(std::uint32_t id) const;
};

struct Beam {
  geom::Vec3 p, d;          // from p along the unit vector d, in W
  double range_max = 0;     // m
  std::uint32_t group = 0;  // tree of the lidar: its own beams ignore it, except after a reflection
};

struct LightEcho {
  bool is_noticed = false;
  double range = 0;     // m
  double returned = 0;  // 1: like a white sheet, perpendicular, at this range
  double power = 0;     // echo_power() of it
};

/// `first` is the first hit of the beam, `weakest` the detection threshold of echo power.
LightEcho echo_of(const RayScene& scene, const Surfaces& surfaces, Beam beam, Met first, double weakest);

/// The hit on the ground plane; id kNobody at the largest range if it misses.
Met ground_met(const Beam& beam);

}  // namespace playhouse::arena
