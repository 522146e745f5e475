#pragma once

/// What a rigid body is, and where it is and how it moves. Frames: W world, B body.

#include <vector>

#include "playhouse/geom/orientation.h"

namespace playhouse::arena {

using geom::Quaternion;
using geom::Vec3;

/// Corners of a convex solid.  [m, in the frame of whatever it is a part of]
using Hull = std::vector<Vec3>;

/// How a surface meets another one: coefficients are multiplied.
struct Surface {
  double friction = 1;
  double restitution = 0;
  double share_x = 1, share_y = 1;  // of the friction, along x and y of whatever has it
  constexpr bool has_grain() const { return share_x != 1 || share_y != 1; }
  friend constexpr bool operator==(const Surface&, const Surface&) = default;
};

/// Where a wheel or a caster of a vehicle touches level ground.
struct Wheel {
  Vec3 p_B;                      // m
  double along = 0, across = 0;  // coefficients of friction in its direction, which is that of x, and across
  double rise = 0.03;            // m above it that the ground may be: what it climbs
  constexpr bool is_caster() const { return along <= 0 && across <= 0; }
};

struct BodyDesc {
  std::vector<Hull> hulls;  // in B
  double mass = 1;          // kg; 0: nothing pushes it, it moves as its velocity says
  Vec3 center;              // of mass  [m, in B]
  Surface surface;
  std::vector<Wheel> wheels;  // none: no vehicle
  bool is_upright = false;    // a vehicle that no contact tilts or turns: it heads where it is driven
};

struct BodyState {
  Vec3 p;        // of B's origin  [m, in W]
  Quaternion q;  // B to W
  Vec3 v;        // of B's origin  [m/s, in W]
  Vec3 w;        // rad/s, in W
};

}  // namespace playhouse::arena
