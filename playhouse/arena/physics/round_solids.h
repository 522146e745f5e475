#pragma once

/// Spheres and capsules, the points within a radius of an axis; and cylinders, the points between two discs.
///
/// In: radius and half length of a round solid, or its hull.
/// Out: its hull, or its axis; moments of inertia.
/// Cost: the corners of a hull.

#include <span>

#include "playhouse/arena/physics/rigid_body.h"

namespace playhouse::arena {

/// The axis of a round solid, in the frame of its hull. Of a sphere both ends are its centre, of a capsule
/// those of its hemispheres.
struct RoundSolid {
  Vec3 low, high;     // ends of the axis  [m]
  double radius = 0;  // m
  Vec3 center() const { return 0.5 * (low + high); }
};

/// A capsule along z about the origin, as a hull with its corners on the surface: hemispheres of `radius` at
/// z = -half and z = half. A sphere for half 0 (1e-9 or less).
Hull round_hull(double radius, double half);

/// A cylinder along z about the origin, likewise; its first corner is one of the low disc. Not round if
/// `radius` or `half` is 0 (1e-9 or less).
Hull cylinder_hull(double radius, double half);

/// That of a hull that is round.
RoundSolid round_of(const Hull& hull);

bool is_any_round(std::span<const Hull> hulls);

/// Moments of inertia about `center`, along the axes of B, of solids in B with `mass` kg in proportion to
/// their volumes: exact for round ones whose axis is along an axis of B; polyhedra as their bounding boxes.
/// Products of inertia are left out.  [kg m^2]
Vec3 moments_of(std::span<const Hull> hulls, const Vec3& center, double mass);

}  // namespace playhouse::arena
