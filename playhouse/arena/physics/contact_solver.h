#pragma once

/// ContactSolver: Bullet's solver with impacts of our own, and as many iterations as stacks need (stacks.h).
/// Slower contacts are Bullet's.
///
/// In: contacts with their distances, and the motion of bodies before the step.
/// Out: per impact, the normal velocity after the step, and the displacement out of a penetration.
/// Cost: some thirty multiplications a contact and step; the iterations are Bullet's.
///
/// Restitution is Newton's: e times the velocity at which the surfaces touched. That is neither the velocity
/// at the step's start nor at its end, and contacts are found some way before or after the surfaces touch:
/// what gravity adds on that way is accounted for, so that energy does not depend on the step.
/// Bullet adds up to 20 % of a penetration per step to the velocity; here an impact's is corrected by a
/// displacement (split impulses: Catto, "Modeling and solving constraints", GDC 2009).

#include "playhouse/arena/physics/bullet.h"

namespace playhouse::arena {

class ContactSolver final : public btSequentialImpulseConstraintSolver {
 public:
  btScalar solveGroup(btCollisionObject** bodies, int body_count, btPersistentManifold** manifolds, int count,
                      btTypedConstraint** constraints, int constraint_count, const btContactSolverInfo& info,
                      btIDebugDraw* drawer, btDispatcher* dispatcher) override;

 private:
  void convertContacts(btPersistentManifold** manifolds, int count, const btContactSolverInfo& info) override;
  void aim(btSolverConstraint& row, bool is_single, const btContactSolverInfo& info) const;
};

}  // namespace playhouse::arena
