#pragma once

/// Wheels as Bullet constraints (wheels.h solves wheels on static ground).
///
/// In: where a wheel touches its support, and what solve_wheels() found for it.
/// Out: rows for Bullet's solver.
/// Cost: three rows, of a wheel without grip one.

#include "playhouse/arena/physics/bullet.h"
#include "playhouse/arena/physics/wheels.h"

namespace playhouse::arena {

/// A wheel on a movable support, solved by Bullet together with the support's contacts; solved separately,
/// the reaction of a heavy vehicle would launch a light support. Rows: normal, along, left; friction is
/// limited by the load from solve_wheels(). Solves for corrections to the impulses of solve_wheels().
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
