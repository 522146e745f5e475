#pragma once

/// Moving: a movable body with its Bullet objects and, if a vehicle, the ground below its wheels.
///
/// In: a description; the state of the body in W.
/// Out: its Bullet objects with that state, and after a step the state with what Bullet made of it.
/// Cost: its hulls when it is made or bent; afterwards some products a step, and some for each wheel.

#include <cstdint>
#include <memory>
#include <vector>

#include "playhouse/arena/physics/bullet_shapes.h"
#include "playhouse/arena/physics/supports.h"
#include "playhouse/arena/physics/wheels.h"

namespace playhouse::arena {

struct Moving {
  RigidBodyDesc desc;
  std::unique_ptr<ConvexShapes> solids;
  Cores cores;
  std::unique_ptr<btRigidBody> body;
  Inertia inertia;
  BodyState state;
  double low = 1e300, reach = 0;  // m: height of its lowest corner; radius about its upright axis
  bool is_sleeping = false, is_woken = false;
  geom::Twist velocity;  // commanded
  std::vector<Footing> footings;
  std::vector<WheelImpulse> impulses;
  std::vector<RigidBodyRow> below;     // support candidates: scratch
  std::vector<RigidBodyRow> supports;  // the body below each wheel, or none
  bool is_held = false;                // wheels as Bullet constraints: it pushes a support or is one

  explicit Moving(const RigidBodyDesc& of);
  bool is_guided() const { return desc.mass == 0; }
  bool is_vehicle() const { return !desc.wheels.empty(); }

  Aabb box() const;
  /// The box in which the ground below its wheels may be.
  Aabb footprint() const;
  /// The velocity of its material point at p.  [m/s, both in W]
  Vec3 velocity_at(const Vec3& p) const { return state.v + cross(state.w, p - state.p); }

  /// True if only its wheels can reach the ground before the next call.
  bool is_on_wheels() const;

  /// Copies the state to Bullet, whose origin is the centre of mass.
  void write();
  /// Copies the state from Bullet, unless the body is kinematic.
  void read();
  void wake() {
    is_sleeping = false;
    write();
  }
  /// Integrates a kinematic body over a step.
  void advance(double dt);
};

}  // namespace playhouse::arena
