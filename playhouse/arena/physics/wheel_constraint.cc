#include "playhouse/arena/physics/wheel_constraint.h"

#include <algorithm>

namespace playhouse::arena {
namespace {

void limit(btTypedConstraint::btConstraintInfo2* info, int row, double most, const ImpulseRange& motor,
           double now) {
  const int at = row * info->rowskip;
  info->m_lowerLimit[at] = std::max(-most, motor.low) - now;
  info->m_upperLimit[at] = std::min(most, motor.high) - now;
}

}  // namespace

void WheelConstraint::getInfo1(btConstraintInfo1* info) {
  info->m_numConstraintRows = target_.is_gripped() ? 3 : 1;
  info->nub = 0;
}

void WheelConstraint::getInfo2(btConstraintInfo2* info) {
  put(info, 0, target_.normal, target_.v_normal);
  info->m_lowerLimit[0] = -impulse_.normal;
  info->m_upperLimit[0] = SIMD_INFINITY;
  if (!target_.is_gripped()) return;
  put(info, 1, target_.along, target_.v_along);
  limit(info, 1, target_.grip_along * impulse_.normal, impulse_.motor_along, impulse_.along);
  put(info, 2, target_.left, target_.v_left);
  limit(info, 2, target_.grip_left * impulse_.normal, impulse_.motor_across, impulse_.across);
}

void WheelConstraint::put(btConstraintInfo2* info, int row, const Vec3& direction, double velocity) const {
  const int at = row * info->rowskip;
  const btVector3 n = bullet(direction), p = bullet(p_);
  const auto write = [at](btScalar* to, const btVector3& v) {
    for (int k = 0; k < 3; ++k) to[at + k] = v[k];
  };
  write(info->m_J1linearAxis, n);
  write(info->m_J1angularAxis, (p - m_rbA.getWorldTransform().getOrigin()).cross(n));
  write(info->m_J2linearAxis, -n);
  write(info->m_J2angularAxis, -(p - m_rbB.getWorldTransform().getOrigin()).cross(n));
  info->m_constraintError[at] = velocity;
}

}  // namespace playhouse::arena
