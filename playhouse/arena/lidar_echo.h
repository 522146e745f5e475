#pragma once

/// What comes back along a beam of light: from the first surface that sends enough of it back, however often
/// the beam was mirrored or let through on its way. Lengths are those of the whole way.
///
/// In: the triangles, what surfaces do to light, a beam and what it met first.
///
/// Out: how far away it seems to be, and the share of the light that it returns.
///
/// Cost: a ray for each mirror and each face of a pane on the way, at most kBounces.
///
/// Source: optics.h.

#include <cstdint>
#include <span>

#include "playhouse/arena/optics.h"
#include "playhouse/arena/ray_scene.h"
#include "playhouse/world/world.h"

namespace playhouse::arena {

inline constexpr int kBounces = 4;
inline constexpr std::uint32_t kGround = 0xfffffffe;  // as the id of what is met: the plane z = 0

/// What a beam meets.
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
  std::uint32_t group = 0;  // of the tree that carries the lidar, which its beams pass but for in mirrors
};

struct LightEcho {
  bool is_noticed = false;
  double range = 0;     // m
  double returned = 0;  // 1: as a white sheet, square on, at this range
  double power = 0;     // echo_power() of it
};

/// `first` is what the beam meets first; `weakest` the power of what is noticed.
LightEcho echo_of(const RayScene& scene, const Surfaces& surfaces, Beam beam, Met first, double weakest);

/// Where it meets the ground: at its largest range, nobody, where it does not.
Met ground_met(const Beam& beam);

}  // namespace playhouse::arena
