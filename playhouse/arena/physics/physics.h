#pragma once

/// Physics: rigid bodies with contacts by Bullet in double precision, and wheels by a
/// solver of our own (wheels.h). A step is a function of body states alone: clear_contacts() drops
/// Bullet's cached contacts, so that a run resumed from a saved state is bit-identical.
/// Frames: W world, B body. Call from one thread at a time; step() runs on workers.
///
/// In: bodies with their states, static solids, commanded velocities of vehicles.
/// Out: states after a step; penetrations.
/// Cost: a step grows with the pairs of bodies whose boxes overlap, and with their contacts, times the
///   iterations that stacks need (stacks.h).

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "playhouse/arena/physics/rigid_body.h"
#include "playhouse/arena/triangles.h"
#include "playhouse/world/workers.h"

namespace playhouse::arena {

/// A static solid: a convex hull, or a triangle mesh if `hull` is empty.
struct FixedSolid {
  Hull hull;  // in W
  ContactSurface surface;
  double heading = 0;     // rad, of the x axis of the anisotropic friction
  Triangles triangles{};  // in W
};

/// A penetration of a body into another.
struct Penetration {
  RigidBodyRow body;
  HullRow hull;      // of the body
  Vec3 p;            // in W
  Vec3 out;          // unit vector out of the body, in W
  double depth = 0;  // m
};

/// Share of a penetration that contacts correct in a step of `dt` seconds.
double correction(double dt);

class Physics {
 public:
  /// `gravity` in m/s^2, downwards.
  explicit Physics(const ContactSurface& ground = {}, double gravity = 9.81);
  ~Physics();
  Physics(const Physics&) = delete;
  Physics& operator=(const Physics&) = delete;

  /// Replaces the static solids by the ground, the plane z = 0, and these.
  void set_fixed(std::span<const FixedSolid> solids);
  /// Adds a movable body, at rest at the origin, behind those that there are.
  RigidBodyRow add(const RigidBodyDesc& desc);
  /// Removes all movable bodies.
  void clear();
  std::size_t size() const;

  /// Replaces its hulls in B, when a joint has moved.
  void set_hulls(RigidBodyRow body, std::span<const Hull> hulls);
  BodyState state(RigidBodyRow body) const;
  /// Sets the state. A body that rests (sleeps) does not move until another one touches it.
  void put(RigidBodyRow body, const BodyState& state, bool is_sleeping);
  bool is_sleeping(RigidBodyRow body) const;
  /// False if a kinematic body has woken it since put(), as its support may be about to leave;
  /// and for a vehicle whose wheels are pressed into the ground, as its load may have left.
  bool may_sleep(RigidBodyRow body) const;
  /// Sets the commanded velocity of a vehicle, of B in B.  [m/s, rad/s]
  void drive(RigidBodyRow body, const geom::Twist& velocity);

  /// Drops state cached between steps: contacts and their impulses (warm start).
  void clear_contacts();
  /// Advances by `dt` seconds. The result does not depend on the number of workers.
  void step(double dt, world::Workers& workers);
  /// After a step: penetrations deeper than
  /// `depth`, except between two kinematic bodies.
  std::vector<Penetration> penetrations(double depth) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace playhouse::arena
