#include "playhouse/arena/physics/wheels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "playhouse/simd/vectors.h"

namespace playhouse::arena {
namespace {

using simd::Double4;
using simd::kFour;
using simd::load;
using simd::store;

constexpr int kIterations = 20;         // limit,
constexpr double kConverged = 1e-7;     // m/s, change of motion by an iteration that ends them
constexpr double kPushOut = 0.2;        // share of a penetration corrected in a step
constexpr double kClimb = 1;            // m/s, limit of that correction
constexpr double kSlop = 1e-4;          // m of tolerated penetration
constexpr double kEven = 1e-3;          // m, tolerance for ground level with a wheel
constexpr double kSimilarNormal = 0.8;  // cosine between ground normals of a common plane
constexpr double kTravel = 0.06;        // m, suspension travel of casters
constexpr double kUsedUp = 1e-9;        // share of a motor's impulse that is no more than rounding

/// A wheel in contact. Members are row numbers of Rows.
struct Contact {
  std::size_t normal = 0, along = 0, across = 0;  // the last two not for casters
  double grip_along = 0, grip_across = 0;
  Vec3 up;                           // of the ground
  double x = 0;                      // m forward, in B
  double v_along = 0, v_across = 0;  // m/s of the wheel over the ground, before the step
  bool is_even = false;              // ground level with the wheel
  WheelImpulse* impulse = nullptr;
  bool is_caster() const { return grip_along <= 0 && grip_across <= 0; }
};

/// Constraint rows of one vehicle: directions in which impulses act at wheels,
/// and the residual of each row as impulses change. The coupling (Delassus)
/// matrix is computed once, so that an iteration does not update the motion.
class Rows {
 public:
  PLAYHOUSE_INLINE Rows(const Inertia& inertia, ChassisMotion& motion)
      : per_mass_(inertia.per_mass), motion_(motion) {
    const Vec3 x = motion.q * Vec3{1, 0, 0}, y = motion.q * Vec3{0, 1, 0}, z = motion.q * Vec3{0, 0, 1};
    const auto column = [&](double of_x, double of_y, double of_z) {
      return inertia.per_moment.x * of_x * x + inertia.per_moment.y * of_y * y +
             inertia.per_moment.z * of_z * z;
    };
    turn_x_ = column(x.x, y.x, z.x);
    turn_y_ = column(x.y, y.y, z.y);
    turn_z_ = column(x.z, y.z, z.z);
  }

  /// Adds a row with a warm-start impulse; returns its number.
  PLAYHOUSE_INLINE std::size_t add(const Vec3& direction, const Vec3& from_center, double target,
                                   double impulse) {
    const Vec3 arm = cross(from_center, direction);
    const Vec3 turned = arm.x * turn_x_ + arm.y * turn_y_ + arm.z * turn_z_;
    const std::size_t i = count_++;
    direction_.put(i, direction);
    arm_.put(i, arm);
    turned_.put(i, turned);
    missing_[i] = target - dot(direction, motion_.v) - dot(arm, motion_.w);
    impulse_[i] = impulse;
    return i;
  }
  /// Computes the matrix; call once, after all rows.
  PLAYHOUSE_INLINE void couple() {
    end_ = (count_ + kFour - 1) / kFour * kFour;
    for (std::size_t i = count_; i < end_; ++i) put_none(i);
    for (std::size_t j = 0; j < count_; ++j) {
      const Vec3 pushed = per_mass_ * direction_.at(j), turned = turned_.at(j);
      double* const change = change_[j];
      for (std::size_t i = 0; i < end_; i += kFour) {
        Double4 dx, dy, dz, ax, ay, az;
        load(dx, direction_.x + i);
        load(dy, direction_.y + i);
        load(dz, direction_.z + i);
        load(ax, arm_.x + i);
        load(ay, arm_.y + i);
        load(az, arm_.z + i);
        store<Double4>(change + i, dx * pushed.x + dy * pushed.y + dz * pushed.z + ax * turned.x +
                                       ay * turned.y + az * turned.z);
      }
      effective_[j] = 1 / change[j];
      add_change(change, impulse_[j]);
    }
  }

  PLAYHOUSE_INLINE double impulse(std::size_t row) const { return impulse_[row]; }
  /// kg that an impulse in the row feels
  PLAYHOUSE_INLINE double mass(std::size_t row) const { return effective_[row]; }
  /// The accumulated impulse that would satisfy the row.
  PLAYHOUSE_INLINE double wanted(std::size_t row) const {
    return impulse_[row] + missing_[row] * effective_[row];
  }
  /// Returns the change of impulse.
  PLAYHOUSE_INLINE double set(std::size_t row, double impulse) {
    const double change = impulse - impulse_[row];
    impulse_[row] = impulse;
    add_change(change_[row], change);
    return std::fabs(change);
  }

  /// A combined direction: shares[k] of an impulse in row rows[k].
  struct Together {
    std::array<std::size_t, 4> rows;
    std::array<double, 4> shares;
    double change[3 * kMostWheels];
  };
  PLAYHOUSE_INLINE void couple(Together& together) const {
    for (std::size_t i = 0; i < end_; i += kFour) {
      Double4 sum = {0, 0, 0, 0}, change;
      for (std::size_t k = 0; k < together.rows.size(); ++k) {
        load(change, change_[together.rows[k]] + i);
        sum += together.shares[k] * change;
      }
      store(together.change + i, sum);
    }
  }
  PLAYHOUSE_INLINE void add(const Together& together, double impulse) {
    for (std::size_t k = 0; k < together.rows.size(); ++k)
      impulse_[together.rows[k]] += together.shares[k] * impulse;
    add_change(together.change, impulse);
  }

  /// The impulse vector of a row in W.
  PLAYHOUSE_INLINE Vec3 push_of(std::size_t row) const { return impulse_[row] * direction_.at(row); }
  /// Applies all impulses to the motion.
  PLAYHOUSE_INLINE void push() {
    for (std::size_t i = 0; i < count_; ++i) {
      motion_.v = motion_.v + per_mass_ * push_of(i);
      motion_.w = motion_.w + impulse_[i] * turned_.at(i);
    }
  }

 private:
  static constexpr std::size_t kMost = 3 * kMostWheels;
  struct Vectors {
    double x[kMost], y[kMost], z[kMost];

    PLAYHOUSE_INLINE Vec3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
    PLAYHOUSE_INLINE void put(std::size_t i, const Vec3& v) {
      x[i] = v.x;
      y[i] = v.y;
      z[i] = v.z;
    }
  };

  /// Pads the last vector of rows.
  PLAYHOUSE_INLINE void put_none(std::size_t i) {
    direction_.put(i, {});
    arm_.put(i, {});
    turned_.put(i, {});
    missing_[i] = impulse_[i] = 0;
  }
  PLAYHOUSE_INLINE void add_change(const double* per_impulse, double impulse) {
    for (std::size_t i = 0; i < end_; i += kFour) {
      Double4 missing, change;
      load(missing, missing_ + i);
      load(change, per_impulse + i);
      store<Double4>(missing_ + i, missing - impulse * change);
    }
  }

  double per_mass_;
  ChassisMotion& motion_;
  Vec3 turn_x_, turn_y_, turn_z_;     // columns of the inverse of the moment of inertia, in W
  std::size_t count_ = 0, end_ = 0;   // of rows, and of those that are worked on, four at a time
  Vectors direction_, arm_, turned_;  // arm: of the direction; turned: rad/s per N s
  double missing_[kMost], impulse_[kMost], effective_[kMost];  // m/s, N s, kg
  double change_[kMost][kMost];                                // m/s of a row per N s of another
};

/// Friction of the ground in a direction.
PLAYHOUSE_INLINE double friction_along(const Footing& footing, const Vec3& direction) {
  if (!footing.has_grain) return footing.friction;
  const double x = dot(footing.grain_x, direction), y = dot(footing.grain_y, direction),
               z = dot(footing.grain_z, direction);
  return footing.friction * std::sqrt(x * x + y * y + z * z);
}

/// Unit vector; the x axis for the zero vector.
PLAYHOUSE_INLINE Vec3 unit(const Vec3& v) {
  const double length = std::sqrt(dot(v, v));
  return length > 0 ? (1 / length) * v : Vec3{1, 0, 0};
}

PLAYHOUSE_INLINE WheelTarget target_of(const Wheel& wheel, const Footing& footing, const Vec3& ahead,
                                       const geom::Twist& velocity, double dt) {
  WheelTarget target;
  target.normal = footing.normal;
  target.left = unit(cross(footing.normal, ahead));
  target.along = cross(target.left, footing.normal);
  target.v_normal = footing.gap > 0 ? -footing.gap / dt
                                    : std::min(kPushOut * std::max(0.0, -footing.gap - kSlop) / dt, kClimb);
  target.v_along = velocity.x - velocity.a * wheel.p_B.y;
  target.v_left = velocity.y + velocity.a * wheel.p_B.x;
  const bool stands = velocity == geom::Twist{};
  const double brake = stands && wheel.is_caster() ? wheel.brake : 0;
  target.grip_along = std::max(wheel.along, brake) * friction_along(footing, target.along);
  target.grip_left = std::max(wheel.across, brake) * friction_along(footing, target.left);
  return target;
}

/// Unilateral normal constraint. Returns the change of impulse. [N s]
PLAYHOUSE_INLINE double press(const Contact& contact, Rows& rows) {
  return rows.set(contact.normal, std::max(0.0, rows.wanted(contact.normal)));
}

/// What the motor of a wheel can do in a step.
struct Motor {
  double push = 0, work = 0, mass = 0;  // N s, J; its share of the mass in kg
  bool is_sideways = false;

  /// The largest impulse towards where it moves at v.  [N s]
  double most(double v) const {
    const double by_power = work < Motors::kNoLimit ? mass * (std::sqrt(v * v + 2 * work / mass) - v) : work;
    return std::min(push, by_power);
  }
  ImpulseRange range(double v) const { return {-most(-v), most(v)}; }
};

/// Limits what a wheel is pushed along the ground. What is driven sideways as well pushes in the direction of
/// the velocity that it lacks, whatever mass it feels in either.
void limit(const Motor& motor, const Contact& contact, const Rows& rows, double& along, double& across) {
  if (!motor.is_sideways) {
    const ImpulseRange range = motor.range(contact.v_along);
    along = std::clamp(along, range.low, range.high);
    return;
  }
  const double v_along = along / rows.mass(contact.along), v_across = across / rows.mass(contact.across);
  const double v = std::sqrt(v_along * v_along + v_across * v_across);
  if (v <= 0) return;
  const double most = motor.most((v_along * contact.v_along + v_across * contact.v_across) / v);
  if (along * along + across * across <= most * most) return;
  along = most / v * v_along;
  across = most / v * v_across;
}

/// What the motor can still do at a wheel after its impulses. What is driven sideways and used up may push
/// less in either direction, not more: each alone would be within its limit, both together not.
void note_ranges(const Motor& motor, const Contact& contact, double along, double across,
                 WheelImpulse& impulse) {
  impulse.motor_along = motor.range(contact.v_along);
  if (!motor.is_sideways) return;
  impulse.motor_across = motor.range(contact.v_across);
  const double total = std::sqrt(along * along + across * across);
  const double v = total > 0 ? (along * contact.v_along + across * contact.v_across) / total : 0;
  if (total < motor.most(v) * (1 - kUsedUp)) return;
  impulse.motor_along = {-std::fabs(along), std::fabs(along)};
  impulse.motor_across = {-std::fabs(across), std::fabs(across)};
}

/// Friction limited by the load, and by the motor if there is one to heed. Returns the change of impulses. [N
/// s]
PLAYHOUSE_INLINE double grip(const Contact& contact, const Motor* motor, Rows& rows) {
  double along = rows.wanted(contact.along), across = rows.wanted(contact.across);
  if (motor != nullptr) limit(*motor, contact, rows, along, across);
  const double load = rows.impulse(contact.normal);
  const double most_along = contact.grip_along * load, most_across = contact.grip_across * load;
  if (most_along <= 0 || most_across <= 0) {
    along = std::clamp(along, -most_along, most_along);
    across = std::clamp(across, -most_across, most_across);
  } else {
    const double share_along = along * most_across, share_across = across * most_along,
                 most = most_along * most_across,
                 used = share_along * share_along + share_across * share_across;
    if (used > most * most) {
      const double left = most / std::sqrt(used);
      along *= left;
      across *= left;
    }
  }
  const double change = rows.set(contact.along, along);
  return change + rows.set(contact.across, across);
}

/// Two driven wheels between two casters, all in contact.
struct Axle {
  std::array<const Contact*, 2> driven{}, casters{};
  double share = -1;  // share of the axle's load on the second caster; negative: no such axle
};

PLAYHOUSE_INLINE Axle axle_of(std::span<const Contact> contacts) {
  Axle axle;
  if (contacts.size() != 4) return axle;
  std::size_t driven_count = 0, caster_count = 0;
  for (const Contact& contact : contacts) {
    if (!contact.is_even || dot(contact.up, contacts[0].up) < kSimilarNormal) return axle;
    if (contact.is_caster() ? caster_count == 2 : driven_count == 2) return axle;
    (contact.is_caster() ? axle.casters[caster_count++] : axle.driven[driven_count++]) = &contact;
  }
  const double first = axle.casters[0]->x, apart = axle.casters[1]->x - first;
  const double share = apart == 0 ? -1 : (axle.driven[0]->x - first) / apart;
  if (share >= 0 && share <= 1) axle.share = share;
  return axle;
}

/// The redistribution of load from an axle's casters to its wheels.
PLAYHOUSE_INLINE Rows::Together unloading_of(const Axle& axle, const Rows& rows) {
  Rows::Together unloading;
  unloading.rows = {axle.casters[0]->normal, axle.casters[1]->normal, axle.driven[0]->normal,
                    axle.driven[1]->normal};
  unloading.shares = {axle.share - 1, -axle.share, 0.5, 0.5};
  rows.couple(unloading);
  return unloading;
}

/// The load split between casters and axle is statically indeterminate: chooses the least caster
/// load that prevents tipping, like sprung casters; otherwise a tall vehicle would spin its wheels.
PLAYHOUSE_INLINE void unload_casters(const Axle& axle, const Rows::Together& unloading, Rows& rows) {
  const double share = axle.share;
  const double of_first = rows.impulse(axle.casters[0]->normal),
               of_second = rows.impulse(axle.casters[1]->normal);
  rows.add(unloading, share == 0   ? of_first
                      : share == 1 ? of_second
                                   : std::min(of_first / (1 - share), of_second / share));
}

/// Projected Gauss-Seidel until impulses change by less than `enough`.  [N s]
PLAYHOUSE_INLINE void iterate(std::span<const Contact> contacts, const Motor* motor, double enough,
                              Rows& rows) {
  const Axle axle = axle_of(contacts);
  const bool has_axle = axle.share >= 0;
  Rows::Together unloading;
  if (has_axle) unloading = unloading_of(axle, rows);
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    double change = 0;
    if (has_axle) unload_casters(axle, unloading, rows);  // before press(), which corrects its effect
    for (const Contact& contact : contacts) change += press(contact, rows);
    for (const Contact& contact : contacts)
      if (!contact.is_caster()) change += grip(contact, motor, rows);
    if (change < enough) return;
  }
}

/// The share of a vehicle's motors that each wheel with grip has.
Motor motor_of(const Motors& motors, std::span<const Contact> contacts, double mass, double dt) {
  const auto wheels = static_cast<double>(
      std::ranges::count_if(contacts, [](const Contact& each) { return !each.is_caster(); }));
  return {motors.max_force * dt / wheels, motors.max_power * dt / wheels, mass / wheels,
          motors.push_sideways};
}

PLAYHOUSE_INLINE void solve(const RigidBodyDesc& desc, const Inertia& inertia, const geom::Twist& velocity,
                            double dt, std::span<const Footing> footings, std::span<WheelImpulse> impulses,
                            ChassisMotion& motion) {
  Rows rows(inertia, motion);
  std::array<Contact, kMostWheels> contacts;
  std::size_t count = 0;
  const Vec3 ahead = motion.q * Vec3{1, 0, 0};
  for (std::size_t i = 0; i < desc.wheels.size(); ++i) {
    const Footing& footing = footings[i];
    if (!footing.is_near) {
      impulses[i] = {};
      continue;
    }
    const Wheel& wheel = desc.wheels[i];
    const WheelTarget target = target_of(wheel, footing, ahead, velocity, dt);
    const Vec3 from_center = motion.q * (wheel.p_B - desc.center);
    Contact& contact = contacts[count++];
    contact.grip_along = target.grip_along;
    contact.grip_across = target.grip_left;
    contact.up = footing.normal;
    contact.x = wheel.p_B.x;
    contact.is_even = std::fabs(footing.gap) < kEven;
    contact.impulse = &impulses[i];
    contact.normal = rows.add(target.normal, from_center, target.v_normal + dot(target.normal, footing.v),
                              impulses[i].normal);
    if (contact.is_caster()) continue;
    const Vec3 v = motion.v + cross(motion.w, from_center) - footing.v;
    contact.v_along = dot(target.along, v);
    contact.v_across = dot(target.left, v);
    contact.along =
        rows.add(target.along, from_center, target.v_along + dot(target.along, footing.v), impulses[i].along);
    contact.across =
        rows.add(target.left, from_center, target.v_left + dot(target.left, footing.v), impulses[i].across);
  }
  rows.couple();
  const std::span<const Contact> met(contacts.data(), count);
  const bool has_limits = desc.motors.have_limits();
  const Motor motor = has_limits ? motor_of(desc.motors, met, 1 / inertia.per_mass, dt) : Motor{};
  iterate(met, has_limits ? &motor : nullptr, kConverged / inertia.per_mass, rows);
  rows.push();
  for (std::size_t i = 0; i < count; ++i) {
    const Contact& contact = contacts[i];
    WheelImpulse& impulse = *contact.impulse;
    impulse = {rows.impulse(contact.normal), 0, 0, rows.push_of(contact.normal), {}, {}};
    if (contact.is_caster()) continue;
    impulse.along = rows.impulse(contact.along);
    impulse.across = rows.impulse(contact.across);
    if (has_limits) note_ranges(motor, contact, impulse.along, impulse.across, impulse);
    impulse.total = impulse.total + rows.push_of(contact.along) + rows.push_of(contact.across);
  }
}

}  // namespace

WheelTarget wheel_target(const Wheel& wheel, const Footing& footing, const Quaternion& q,
                         const geom::Twist& velocity, double dt) {
  return target_of(wheel, footing, q * Vec3{1, 0, 0}, velocity, dt);
}

void let_casters_give_way(const RigidBodyDesc& desc, std::span<Footing> footings) {
  // wheels_of() lists the driven wheels of an axle first, then its casters.
  const std::vector<Wheel>& wheels = desc.wheels;
  if (wheels.size() != 4 || wheels[0].is_caster() || wheels[1].is_caster() || !wheels[2].is_caster() ||
      !wheels[3].is_caster())
    return;
  for (const Footing& footing : footings)
    if (!footing.is_near) return;
  const double first = wheels[2].p_B.x, apart = wheels[3].p_B.x - first;
  if (apart == 0) return;
  const double share = (wheels[0].p_B.x - first) / apart;
  const double casters = (1 - share) * footings[2].gap + share * footings[3].gap;
  const double hollow = 0.5 * (footings[0].gap + footings[1].gap) - casters;
  if (hollow < kEven) return;
  for (Footing& footing : footings.subspan(2)) footing.gap += std::min(hollow, kTravel);
}

void solve_wheels(const RigidBodyDesc& desc, const Inertia& inertia, const geom::Twist& velocity, double dt,
                  std::span<const Footing> footings, std::span<WheelImpulse> impulses,
                  ChassisMotion& motion) {
  simd::in_vectors<solve>(desc, inertia, velocity, dt, footings, impulses, motion);
}

}  // namespace playhouse::arena
