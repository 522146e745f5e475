#pragma once

/// Moving: a body that moves, with what Bullet has of it and, of a vehicle, what its wheels stand on.

#include <cstdint>
#include <memory>
#include <vector>

#include "playhouse/arena/bullet_shapes.h"
#include "playhouse/arena/supports.h"
#include "playhouse/arena/wheels.h"

namespace playhouse::arena {

inline constexpr std::uint32_t kNobody = 0xffffffff;

struct Moving {
  BodyDesc desc;
  std::unique_ptr<ConvexShapes> solids;
  std::unique_ptr<btRigidBody> body;
  Inertia inertia;
  BodyState state;
  double low = 1e300, reach = 0;  // m: its lowest corner, and how far the farthest is from its upright axis
  bool rests = false, is_woken = false;
  geom::Twist velocity;  // driven at
  std::vector<Footing> footings;
  std::vector<WheelImpulse> impulses;
  std::vector<std::uint32_t> below;     // bodies that its wheels may stand on: scratch
  std::vector<std::uint32_t> supports;  // the body that each wheel stands on, or kNobody
  bool is_held = false;                 // its wheels are for Bullet to solve, too: it pushes one or is pushed

  explicit Moving(const BodyDesc& of);
  bool is_guided() const { return desc.mass == 0; }
  bool is_vehicle() const { return !desc.wheels.empty(); }

  Box box() const;
  /// Where the ground may be that its wheels stand on.
  Box footprint() const;
  /// Of what of it is at p.  [m/s, both in W]
  Vec3 velocity_at(const Vec3& p) const { return state.v + cross(state.w, p - state.p); }

  /// So that nothing but its wheels can come to the ground before this is asked again.
  bool is_on_wheels() const;

  /// The state to Bullet, which moves the centre of mass.
  void write();
  /// The state from Bullet, unless nothing pushes the body.
  void read();
  void wake() {
    rests = false;
    write();
  }
  /// On by a step, of a body that nothing pushes.
  void advance(double dt);
};

}  // namespace playhouse::arena
