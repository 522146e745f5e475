#pragma once

/// Description and state of a rigid body. Frames: W world, B body. Values.

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "playhouse/base/row.h"
#include "playhouse/geom/orientation.h"

namespace playhouse::arena {

using geom::Quaternion;
using geom::Vec3;

/// What a solid is in contacts: a polyhedron, or a round solid (round_solids.h).
enum class Round : std::uint8_t { kNot, kSphere, kCapsule, kCylinder };

/// Corners of a convex solid.  [m, in the frame of its owner] Those of a round one are its outline, moved and
/// turned as a whole: where it is follows from them. Who moves them otherwise makes it a polyhedron.
struct Hull : std::vector<Vec3> {
  using vector::vector;
  Hull() = default;
  Hull(std::vector<Vec3> corners) : vector(std::move(corners)) {}
  Round round = Round::kNot;
};

using HullRow = Row<Hull>;                   // of a body
using RigidBodyRow = Row<struct RigidBody>;  // of Physics

/// Surface properties. Friction coefficients of two surfaces in contact
/// are multiplied; of the coefficients of restitution the larger one applies.
struct ContactSurface {
  double friction = 1;
  double restitution = 0;
  double share_x = 1, share_y = 1;  // factors of friction along the owner's x and y
  constexpr bool has_grain() const { return share_x != 1 || share_y != 1; }
  friend constexpr bool operator==(const ContactSurface&, const ContactSurface&) = default;
};

/// Contact point of a wheel or caster of a vehicle with level ground.
struct Wheel {
  Vec3 p_B;                      // m
  double along = 0, across = 0;  // friction coefficients in rolling direction (x) and sideways
  double rise = 0.03;            // m: step height that it climbs
  double brake = 0;              // of a caster: friction coefficient while the vehicle is to stand still
  constexpr bool is_caster() const { return along <= 0 && across <= 0; }
};

/// What the motors of a vehicle can do, shared evenly by the wheels that touch the ground.
struct Motors {
  double max_force = kNoLimit;  // N, along the ground
  double max_power = kNoLimit;  // W
  bool push_sideways = false;   // the wheels are driven sideways, too
  static constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  constexpr bool have_limits() const { return max_force < kNoLimit || max_power < kNoLimit; }
};

struct RigidBodyDesc {
  std::vector<Hull> hulls;  // in B
  double mass = 1;          // kg; 0: kinematic
  Vec3 center;              // of mass  [m, in B]
  ContactSurface surface;
  std::vector<Wheel> wheels;  // none: no vehicle
  bool is_upright = false;    // a vehicle with no roll, pitch or yaw from contacts: it heads where driven
  Motors motors;              // of a vehicle
};

struct BodyState {
  Vec3 p;        // of B's origin  [m, in W]
  Quaternion q;  // B to W
  Vec3 v;        // of B's origin  [m/s, in W]
  Vec3 w;        // rad/s, in W
};

}  // namespace playhouse::arena
