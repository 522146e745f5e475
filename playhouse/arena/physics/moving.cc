#include "playhouse/arena/physics/moving.h"

#include <algorithm>
#include <cmath>

#include "playhouse/arena/physics/round_solids.h"
#include "playhouse/arena/physics/wheel_ray.h"

namespace playhouse::arena {
namespace {

constexpr double kForesight = 0.1;  // s of look-ahead between two calls of Physics::clear_contacts()

}  // namespace

Moving::Moving(const RigidBodyDesc& of)
    : desc(of), solids(std::make_unique<ConvexShapes>(of.hulls, of.center)), cores(of.hulls, of.center) {
  body = make_body(desc.mass, solids->shape(), desc.surface);
  body->setUserPointer(this);
  if (!is_guided() && is_any_round(desc.hulls))  // Bullet would take their bounding box
    body->setMassProps(desc.mass, bullet(moments_of(desc.hulls, desc.center, desc.mass)));
  if (is_guided())
    body->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);  // a static body would never wake others
  if (desc.is_upright) body->setMassProps(desc.mass, {0, 0, 0});      // zero inertia for Bullet: no rotation
  inertia = {body->getInvMass(), from(body->getInvInertiaDiagLocal())};
  for (const Hull& hull : desc.hulls)
    for (const Vec3& p : hull) {
      low = std::min(low, p.z);
      reach = std::max(reach, std::sqrt(p.x * p.x + p.y * p.y));
    }
  footings.resize(desc.wheels.size());
  impulses.resize(desc.wheels.size());
  supports.resize(desc.wheels.size());
  write();
}

Aabb Moving::box() const {
  btVector3 low, high;
  body->getAabb(low, high);
  return {from(low), from(high)};
}

Aabb Moving::footprint() const {
  Aabb box{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
  for (const Wheel& wheel : desc.wheels) {
    const Vec3 p = state.p + state.q * wheel.p_B;
    const double reach = std::max(wheel.rise + kOverlap, kWheelDrop);
    box.low = {std::min(box.low.x, p.x - reach), std::min(box.low.y, p.y - reach),
               std::min(box.low.z, p.z - reach)};
    box.high = {std::max(box.high.x, p.x + reach), std::max(box.high.y, p.y + reach),
                std::max(box.high.z, p.z + reach)};
  }
  return box;
}

bool Moving::is_on_wheels() const {
  if (!is_vehicle()) return false;
  const Vec3 up = state.q * Vec3{0, 0, 1};
  const double lean = std::sqrt(std::max(0.0, 1 - up.z * up.z));
  const double leaning = std::sqrt(state.w.x * state.w.x + state.w.y * state.w.y) * kForesight;
  return up.z > 0 && state.p.z + low * up.z - reach * (lean + leaning) > 0.5 * low;
}

void Moving::write() {
  const Vec3 arm = state.q * desc.center;
  body->setWorldTransform(btTransform(bullet(state.q), bullet(state.p + arm)));
  body->setInterpolationWorldTransform(body->getWorldTransform());
  body->setDeactivationTime(0);
  body->forceActivationState(is_sleeping ? ISLAND_SLEEPING : DISABLE_DEACTIVATION);
  if (is_guided()) return;
  body->setLinearVelocity(bullet(state.v + cross(state.w, arm)));
  body->setAngularVelocity(bullet(state.w));
  body->updateInertiaTensor();
}

void Moving::read() {
  if (is_guided()) return;
  is_sleeping = !body->isActive();
  if (is_sleeping) return;
  const btTransform& X = body->getWorldTransform();
  const btQuaternion q = X.getRotation();
  state.q = {q.w(), q.x(), q.y(), q.z()};
  const Vec3 arm = state.q * desc.center;
  state.p = from(X.getOrigin()) - arm;
  state.w = from(body->getAngularVelocity());
  state.v = from(body->getLinearVelocity()) - cross(state.w, arm);
}

void Moving::advance(double dt) {
  state.p = state.p + dt * state.v;
  const double angle = std::sqrt(dot(state.w, state.w)) * dt;
  if (angle > 0) {
    const btQuaternion turn(bullet(state.w).normalized(), angle);
    state.q = Quaternion{turn.w(), turn.x(), turn.y(), turn.z()} * state.q;
  }
  body->setWorldTransform(btTransform(bullet(state.q), bullet(state.p + state.q * desc.center)));
}

}  // namespace playhouse::arena
