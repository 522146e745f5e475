#pragma once

/// Wheels: the wheel solver of one vehicle for one step. A wheel is a point
/// contact with friction towards its commanded velocity; a caster has no friction,
/// but is braked while the vehicle is to stand still, as a parked robot on a slope
/// is. Rigid cylinders would scrub: they lose a tenth of a turn in place.
///
/// In: the motion of the vehicle after gravity; the gap of each wheel to the ground; the impulses of the
///   previous step, as a warm start.
/// Out: the motion after the step; the impulses.
/// Cost: with n rows, three per wheel and one per caster, 6 n² multiplications, and n² more per iteration, at
///   most kIterations (7 on average in a crowd); 1.4 us for two wheels and two casters.
/// A motor's impulse J in a step of dt is at most F dt, and does the work J v + J²/2m <= P dt on its share m
/// of the mass, which moves at v before the step: a vehicle driven by power alone has v² = 2 P t / m in any
/// step. Source: sequential impulses with warm start (Catto, "Iterative dynamics with temporal coherence",
/// GDC
///   2005), on the Delassus matrix that couples the rows; the friction cone as an ellipse scaled by the load
///   of the wheel.

#include <span>

#include "playhouse/arena/physics/rigid_body.h"

namespace playhouse::arena {

/// Upper bound on wheels and casters of a vehicle.
inline constexpr std::size_t kMostWheels = 8;

/// The ground below a wheel.
struct Footing {
  bool is_near = false;  // false: the wheel is in the air
  double gap = 0;        // from the wheel to the ground, negative if penetrating  [m]
  Vec3 normal{0, 0, 1};  // unit vector, in W
  double friction = 1;   // of the ground; multiplied by the wheel's
  Vec3 v;                // of the ground, if it moves  [m/s, in W]
  // Anisotropic friction of the ground: its
  // axes, each scaled by the factor along it.
  bool has_grain = false;
  Vec3 grain_x, grain_y, grain_z;  // in W
};

struct ImpulseRange {
  double low = -Motors::kNoLimit, high = Motors::kNoLimit;  // N s
};

/// Impulses at a wheel.  [N s]
struct WheelImpulse {
  double normal = 0, along = 0, across = 0;
  Vec3 total;  // their sum, in W
  // What its motor could do in the step, in either direction; of one that also drives sideways and is used
  // up, what it did and less.
  ImpulseRange motor_along, motor_across;
};

/// Target of a wheel's constraints: velocities relative to
/// the ground, and friction limits as multiples of the load.
struct WheelTarget {
  Vec3 normal, along, left;                      // unit vectors, in W
  double v_normal = 0, v_along = 0, v_left = 0;  // m/s: target of the normal row, of the friction rows
  double grip_along = 0, grip_left = 0;          // times the load
  constexpr bool is_gripped() const { return grip_along > 0 || grip_left > 0; }
};
WheelTarget wheel_target(const Wheel& wheel, const Footing& footing, const Quaternion& q,
                         const geom::Twist& velocity, double dt);

/// Emulates sprung casters for a vehicle with two driven wheels: adds to
/// the gaps of its casters what keeps its wheels on the ground in a hollow,
/// such as the foot of a ramp. No effect on even ground or on a crest.
void let_casters_give_way(const RigidBodyDesc& desc, std::span<Footing> footings);

/// Inverse inertia of a vehicle, and the motion of its centre of mass. Frame: W, moments along B's axes.
struct Inertia {
  double per_mass = 0;  // 1/kg
  Vec3 per_moment;      // about the centre of mass, along B's axes  [1/(kg m^2)]
};
struct ChassisMotion {
  Quaternion q;  // B to W
  Vec3 v, w;     // m/s, rad/s
};

/// Changes motion.v and motion.w. `velocity` is the commanded velocity, in B.
void solve_wheels(const RigidBodyDesc& desc, const Inertia& inertia, const geom::Twist& velocity, double dt,
                  std::span<const Footing> footings, std::span<WheelImpulse> impulses, ChassisMotion& motion);

}  // namespace playhouse::arena
