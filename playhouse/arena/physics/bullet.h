#pragma once

/// Conversion of vectors and rotations to and from Bullet's types.
///
/// In: a vector or a rotation.
/// Out: the same in the other type.
/// Cost: a copy.

#include <btBulletDynamicsCommon.h>

#include "playhouse/arena/physics/rigid_body.h"

namespace playhouse::arena {

inline btVector3 bullet(const Vec3& v) {
  return {v.x, v.y, v.z};
}
inline Vec3 from(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}
inline btQuaternion bullet(const Quaternion& q) {
  return {q.x, q.y, q.z, q.w};
}

}  // namespace playhouse::arena
