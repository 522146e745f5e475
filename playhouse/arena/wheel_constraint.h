#pragma once

/// Wheels as constraints of Bullet (wheels.h solves those that stand on what does not move).

#include "playhouse/arena/bullet.h"
#include "playhouse/arena/wheels.h"

namespace playhouse::arena {

/// A wheel on what may be pushed away, for Bullet to solve with the contacts of that: solved without them,
/// the reaction of a heavy vehicle throws a light thing. Rows: normal, along, left, of which friction is
/// within what the load of solve_wheels() gives. Changes of impulses that solve_wheels() found already.
class WheelConstraint final : public btTypedConstraint {
 public:
  WheelConstraint(btRigidBody& vehicle, btRigidBody& support, const Vec3& p, const WheelTarget& target,
                  const WheelImpulse& impulse)
      : btTypedConstraint(MAX_CONSTRAINT_TYPE, vehicle, support), p_(p), target_(target), impulse_(impulse) {}

  void getInfo1(btConstraintInfo1* info) override;
  void getInfo2(btConstraintInfo2* info) override;
  void setParam(int, btScalar, int) override {}
  btScalar getParam(int, int) const override { return 0; }

 private:
  void put(btConstraintInfo2* info, int row, const Vec3& direction, double velocity) const;

  Vec3 p_;  // m, of the wheel in W
  WheelTarget target_;
  WheelImpulse impulse_;
};

}  // namespace playhouse::arena
