#pragma once

/// Wheels: what the wheels of one vehicle do to it in one step. A wheel is a point that the ground bears,
/// with friction towards the velocity that it is driven at; a caster has none. Rigid cylinders would scrub:
/// they lose a tenth of a turn in place.
///
/// In: how the vehicle moves, gravity included; where each wheel is above the ground; the impulses of the
///   step before, from which it starts.
/// Out: how the vehicle moves then; the impulses.
/// Cost: with n rows, three of a wheel and one of a caster, 6 n² multiplications, and in each of up to
///   kIterations (7 on average in a crowd) n² more; 1.4 us for two wheels and two casters.
/// Source: sequential impulses with warm start (Catto, "Iterative dynamics with temporal coherence", GDC
///   2005), on the matrix that couples the rows (Delassus); the cone of friction as an ellipse about the load
///   of the wheel.

#include <span>

#include "playhouse/arena/rigid_body.h"

namespace playhouse::arena {

/// Wheels and casters that a vehicle can have.
inline constexpr std::size_t kMostWheels = 8;

/// The ground below a wheel.
struct Footing {
  bool is_near = false;  // else the wheel is in the air
  double gap = 0;        // from the wheel to the ground; below 0 where it is pressed in  [m]
  Vec3 normal{0, 0, 1};  // unit vector, in W
  double friction = 1;   // of the ground, by which that of the wheel is multiplied
  Vec3 v;                // of the ground, where it moves  [m/s, in W]
  // Where it rubs more in one direction than in another: its axes, each times the share of the friction
  // along it.
  bool has_grain = false;
  Vec3 grain_x, grain_y, grain_z;  // in W
};

/// Impulses at a wheel.  [N s]
struct WheelImpulse {
  double normal = 0, along = 0, across = 0;
  Vec3 total;  // all of them, in W
};

/// What the ground is to do to a wheel: velocities of the wheel from the ground, and how much of the load the
/// friction is.
struct WheelTarget {
  Vec3 normal, along, left;                      // unit vectors, in W
  double v_normal = 0, v_along = 0, v_left = 0;  // m/s: what the load is for; what friction is for
  double grip_along = 0, grip_left = 0;          // times the load
  constexpr bool is_gripped() const { return grip_along > 0 || grip_left > 0; }
};
WheelTarget wheel_target(const Wheel& wheel, const Footing& footing, const Quaternion& q,
                         const geom::Twist& velocity, double dt);

/// Casters of a vehicle with two driven wheels give way, as sprung ones do, by as much as keeps its wheels on
/// the ground in a hollow, such as the foot of a ramp: that is added to their gaps. Nothing on even ground
/// and on a crest.
void let_casters_give_way(const BodyDesc& desc, std::span<Footing> footings);

/// How heavy a vehicle is, and how its centre of mass moves. Frame: W, but for the moments.
struct Inertia {
  double per_mass = 0;  // 1/kg
  Vec3 per_moment;      // about the centre of mass, along B's axes  [1/(kg m^2)]
};
struct Motion {
  Quaternion q;  // B to W
  Vec3 v, w;     // m/s, rad/s
};

/// `velocity` is what the vehicle is driven at, in B. Changes motion.v and motion.w.
void solve_wheels(const BodyDesc& desc, const Inertia& inertia, const geom::Twist& velocity, double dt,
                  std::span<const Footing> footings, std::span<WheelImpulse> impulses, Motion& motion);

}  // namespace playhouse::arena
