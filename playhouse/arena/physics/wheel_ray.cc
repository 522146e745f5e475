#include "playhouse/arena/physics/wheel_ray.h"

namespace playhouse::arena {
namespace {

void add_grain(const btRigidBody& body, Footing& footing) {
  const btMatrix3x3& axes = body.getWorldTransform().getBasis();
  const btVector3& share = body.getAnisotropicFriction();
  footing.has_grain = true;
  footing.grain_x = from(axes.getColumn(0) * share.x());
  footing.grain_y = from(axes.getColumn(1) * share.y());
  footing.grain_z = from(axes.getColumn(2));
}

}  // namespace

bool WheelRay::meet(btRigidBody& body, Footing& footing) const {
  const btTransform begin(btQuaternion::getIdentity(), top), end(btQuaternion::getIdentity(), bottom);
  btCollisionWorld::ClosestRayResultCallback hit(top, bottom);
  btCollisionWorld::rayTestSingle(begin, end, &body, body.getCollisionShape(), body.getWorldTransform(), hit);
  if (!hit.hasHit() || hit.m_closestHitFraction <= 0 || hit.m_hitNormalWorld.z() < kUpright) return false;
  const double gap = hit.m_closestHitFraction * (rise + kWheelDrop) - rise;
  if (footing.is_near && footing.gap < gap) return false;
  footing = {};
  footing.is_near = true;
  footing.gap = gap;
  footing.normal = from(hit.m_hitNormalWorld);
  footing.friction = body.getFriction();
  if (body.hasAnisotropicFriction()) add_grain(body, footing);
  return true;
}

}  // namespace playhouse::arena
