#include "playhouse/arena/wheels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace playhouse::arena {
namespace {

constexpr int kIterations = 20;           // at most,
constexpr double kConverged = 1e-7;       // m/s by which an iteration still changes the motion
constexpr double kPushOut = 0.2;          // of a wheel that is pressed in, a step
constexpr double kClimb = 1;              // m/s at most
constexpr double kSlop = 1e-4;            // m that it may be
constexpr double kEven = 1e-3;            // m between the ground and a wheel on even ground
constexpr double kSameNormal = 1 - 1e-8;  // cosine of the angle between normals of even ground

/// One direction in which an impulse at a wheel acts.
struct Row {
  Vec3 direction, arm;   // the arm is that of the direction about the centre of mass
  Vec3 turned;           // per unit of impulse  [rad/s]
  double target = 0;     // m/s
  double effective = 0;  // kg
};

/// A wheel that touches the ground.
struct Contact {
  Row normal, along, across;
  double grip_along = 0, grip_across = 0;
  double x = 0;          // m ahead, in B
  bool is_even = false;  // the ground is as high as the wheel
  WheelImpulse* impulse = nullptr;
  bool is_caster() const { return grip_along <= 0 && grip_across <= 0; }
};

class Vehicle {
 public:
  Vehicle(const Inertia& inertia, Motion& motion)
      : inertia_(inertia), motion_(motion), to_body_{motion.q.w, -motion.q.x, -motion.q.y, -motion.q.z} {}

  Row row(const Vec3& direction, const Vec3& from_center, double target) const {
    Row row;
    row.direction = direction;
    row.arm = cross(from_center, direction);
    const Vec3 arm_B = to_body_ * row.arm;
    row.turned = motion_.q * Vec3{arm_B.x * inertia_.per_moment.x, arm_B.y * inertia_.per_moment.y,
                                  arm_B.z * inertia_.per_moment.z};
    row.effective = 1 / (inertia_.per_mass + dot(row.arm, row.turned));
    row.target = target;
    return row;
  }
  void push(const Row& row, double impulse) {
    motion_.v = motion_.v + (impulse * inertia_.per_mass) * row.direction;
    motion_.w = motion_.w + impulse * row.turned;
  }
  /// The impulse that brings the row to its target.
  double lack(const Row& row) const {
    return (row.target - dot(row.direction, motion_.v) - dot(row.arm, motion_.w)) * row.effective;
  }

 private:
  const Inertia& inertia_;
  Motion& motion_;
  Quaternion to_body_;
};

/// The friction of the ground in a direction.
double friction_along(const Footing& footing, const Vec3& direction) {
  if (!footing.has_grain) return footing.friction;
  const double x = dot(footing.grain_x, direction), y = dot(footing.grain_y, direction),
               z = dot(footing.grain_z, direction);
  return footing.friction * std::sqrt(x * x + y * y + z * z);
}

/// Without an end where the length is 0.
Vec3 unit(const Vec3& v) {
  const double length = std::sqrt(dot(v, v));
  return length > 0 ? (1 / length) * v : Vec3{1, 0, 0};
}

/// The ground pushes, and does not pull. Returns the change of the impulse. [N s]
double press(Contact& contact, Vehicle& vehicle) {
  const double before = contact.impulse->normal;
  contact.impulse->normal = std::max(0.0, before + vehicle.lack(contact.normal));
  const double change = contact.impulse->normal - before;
  vehicle.push(contact.normal, change);
  return std::fabs(change);
}

/// Friction, no more than the load gives. Returns the change of the impulses. [N s]
double grip(Contact& contact, Vehicle& vehicle) {
  const double load = contact.impulse->normal, along = contact.impulse->along,
               across = contact.impulse->across;
  double next_along = along + vehicle.lack(contact.along),
         next_across = across + vehicle.lack(contact.across);
  const double most_along = contact.grip_along * load, most_across = contact.grip_across * load;
  if (most_along <= 0 || most_across <= 0) {
    next_along = std::clamp(next_along, -most_along, most_along);
    next_across = std::clamp(next_across, -most_across, most_across);
  } else {
    const double share_along = next_along / most_along, share_across = next_across / most_across;
    const double used = std::sqrt(share_along * share_along + share_across * share_across);
    if (used > 1) {
      next_along /= used;
      next_across /= used;
    }
  }
  contact.impulse->along = next_along;
  contact.impulse->across = next_across;
  vehicle.push(contact.along, next_along - along);
  vehicle.push(contact.across, next_across - across);
  return std::fabs(next_along - along) + std::fabs(next_across - across);
}

/// Two driven wheels between two casters, on even ground.
struct Axle {
  std::array<Contact*, 2> driven{}, casters{};
  double share = -1;  // of the axle's load, of the second caster; below 0: there is no such axle
};

Axle axle_of(std::span<Contact> contacts) {
  Axle axle;
  if (contacts.size() != 4) return axle;
  std::size_t driven_count = 0, caster_count = 0;
  for (Contact& contact : contacts) {
    if (!contact.is_even || dot(contact.normal.direction, contacts[0].normal.direction) < kSameNormal)
      return axle;
    if (contact.is_caster() ? caster_count == 2 : driven_count == 2) return axle;
    (contact.is_caster() ? axle.casters[caster_count++] : axle.driven[driven_count++]) = &contact;
  }
  const double first = axle.casters[0]->x, apart = axle.casters[1]->x - first;
  const double share = apart == 0 ? -1 : (axle.driven[0]->x - first) / apart;
  if (share >= 0 && share <= 1) axle.share = share;
  return axle;
}

/// Such wheels bear a vehicle in more than one way: what both casters take off the axle leaves its motion as
/// it is. Here they take as little as keeps it from tipping, as sprung casters do; a tall vehicle would spin
/// its wheels else.
void unload_casters(const Axle& axle, Vehicle& vehicle) {
  if (axle.share < 0) return;
  const double share = axle.share;
  const double of_first = axle.casters[0]->impulse->normal, of_second = axle.casters[1]->impulse->normal;
  const double moved = share == 0   ? of_first
                       : share == 1 ? of_second
                                    : std::min(of_first / (1 - share), of_second / share);
  const auto add = [&](Contact& contact, double impulse) {
    contact.impulse->normal += impulse;
    vehicle.push(contact.normal, impulse);
  };
  add(*axle.casters[0], -moved * (1 - share));
  add(*axle.casters[1], -moved * share);
  for (Contact* const wheel : axle.driven) add(*wheel, 0.5 * moved);
}

/// Until impulses change by less than `enough`.  [N s]
void iterate(std::span<Contact> contacts, double enough, Vehicle& vehicle) {
  const Axle axle = axle_of(contacts);
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    double change = 0;
    unload_casters(axle, vehicle);  // before press(), which mends what it changes
    for (Contact& contact : contacts) change += press(contact, vehicle);
    for (Contact& contact : contacts)
      if (!contact.is_caster()) change += grip(contact, vehicle);
    if (change < enough) return;
  }
}

}  // namespace

void solve_wheels(const BodyDesc& desc, const Inertia& inertia, const geom::Twist& velocity, double dt,
                  std::span<const Footing> footings, std::span<WheelImpulse> impulses, Motion& motion) {
  Vehicle vehicle(inertia, motion);
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
    const Vec3 from_center = motion.q * (wheel.p_B - desc.center);
    const Vec3 left = unit(cross(footing.normal, ahead)), along = cross(left, footing.normal);
    const double in_or_out = footing.gap > 0
                                 ? -footing.gap / dt
                                 : std::min(kPushOut * std::max(0.0, -footing.gap - kSlop) / dt, kClimb);
    Contact& contact = contacts[count++];
    contact.normal = vehicle.row(footing.normal, from_center, in_or_out + dot(footing.normal, footing.v));
    contact.along =
        vehicle.row(along, from_center, velocity.x - velocity.a * wheel.p_B.y + dot(along, footing.v));
    contact.across =
        vehicle.row(left, from_center, velocity.y + velocity.a * wheel.p_B.x + dot(left, footing.v));
    contact.grip_along = wheel.along * friction_along(footing, along);
    contact.grip_across = wheel.across * friction_along(footing, left);
    contact.x = wheel.p_B.x;
    contact.is_even = std::fabs(footing.gap) < kEven;
    contact.impulse = &impulses[i];
    vehicle.push(contact.normal, contact.impulse->normal);
    vehicle.push(contact.along, contact.impulse->along);
    vehicle.push(contact.across, contact.impulse->across);
  }
  iterate({contacts.data(), count}, kConverged / inertia.per_mass, vehicle);
  for (std::size_t i = 0; i < count; ++i) {
    const Contact& contact = contacts[i];
    WheelImpulse& impulse = *contact.impulse;
    impulse.total = impulse.normal * contact.normal.direction + impulse.along * contact.along.direction +
                    impulse.across * contact.across.direction;
  }
}

}  // namespace playhouse::arena
