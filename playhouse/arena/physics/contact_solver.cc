#include "playhouse/arena/physics/contact_solver.h"

#include <algorithm>
#include <cmath>

#include "playhouse/arena/physics/stacks.h"

namespace playhouse::arena {
namespace {

constexpr double kBounce = 0.2;  // m/s; slower impacts, of 2 mm of fall, do not bounce

/// A contact along its normal. Positive: apart.
struct Approach {
  double gap = 0;           // m
  double velocity = 0;      // m/s, at the start of the step, without the forces of the step
  double acceleration = 0;  // m/s^2, by forces
  double dt = 0;            // s

  double velocity_after() const { return velocity + dt * acceleration; }
  /// The integrator moves bodies by the velocity at the end of a step: on the same parabola, the velocity at
  /// its start is half a step of acceleration ahead.
  double velocity_now() const { return velocity + 0.5 * dt * acceleration; }

  /// The squared velocity when the surfaces touch, a gap away.
  double impact2() const { return velocity_now() * velocity_now() - 2 * acceleration * gap; }
  /// True if they touch before the end of the step, or overlap, and are fast.
  bool is_impact() const {
    return velocity_now() < 0 && impact2() > kBounce * kBounce &&
           gap + dt * std::min(0.0, velocity_after()) <= 0;
  }
  /// The velocity after the step with restitution e, if it was `impact2` when the surfaces touched.
  double rebound(double e) const {
    const double now2 = e * e * impact2() + 2 * acceleration * gap;
    return std::sqrt(std::max(0.0, now2)) + 0.5 * dt * acceleration;
  }
};

}  // namespace

btScalar ContactSolver::solveGroup(btCollisionObject** bodies, int body_count,
                                   btPersistentManifold** manifolds, int count,
                                   btTypedConstraint** constraints, int constraint_count,
                                   const btContactSolverInfo& info, btIDebugDraw* drawer,
                                   btDispatcher* dispatcher) {
  btContactSolverInfo of_group = info;
  of_group.m_numIterations = static_cast<int>(info.m_numIterations * more_iterations(manifolds, count));
  return btSequentialImpulseConstraintSolver::solveGroup(bodies, body_count, manifolds, count, constraints,
                                                         constraint_count, of_group, drawer, dispatcher);
}

void ContactSolver::convertContacts(btPersistentManifold** manifolds, int count,
                                    const btContactSolverInfo& info) {
  for (int i = 0; i < count; ++i) {
    int row = m_tmpSolverContactConstraintPool.size();
    btSequentialImpulseConstraintSolver::convertContacts(manifolds + i, 1, info);
    const bool is_single = manifolds[i]->getNumContacts() == 1;
    for (; row < m_tmpSolverContactConstraintPool.size(); ++row)
      aim(m_tmpSolverContactConstraintPool[row], is_single, info);
  }
}

/// Sets the targets of an impact: the velocity after the step, and the displacement out of a penetration.
/// If the nearest points are all that is known of bodies that are not there yet, they go on, to have contacts
/// at all corners of their faces in the next step: a single one would turn them.
void ContactSolver::aim(btSolverConstraint& row, bool is_single, const btContactSolverInfo& info) const {
  const auto& point = *static_cast<const btManifoldPoint*>(row.m_originalContactPoint);
  const btSolverBody &a = m_tmpSolverBodyPool[row.m_solverBodyIdA],
                     &b = m_tmpSolverBodyPool[row.m_solverBodyIdB];
  const auto along = [&row](const btVector3& v_a, const btVector3& w_a, const btVector3& v_b,
                            const btVector3& w_b) {
    return row.m_contactNormal1.dot(v_a) + row.m_relpos1CrossNormal.dot(w_a) + row.m_contactNormal2.dot(v_b) +
           row.m_relpos2CrossNormal.dot(w_b);
  };
  const double dt = info.m_timeStep, e = point.m_combinedRestitution;
  const double gained = along(a.m_externalForceImpulse, a.m_externalTorqueImpulse, b.m_externalForceImpulse,
                              b.m_externalTorqueImpulse);
  const Approach approach{
      point.getDistance(),
      along(a.m_linearVelocity, a.m_angularVelocity, b.m_linearVelocity, b.m_angularVelocity), gained / dt,
      dt};
  if (!approach.is_impact()) return;
  double after = e > 0 ? approach.rebound(e) : std::min(0.0, -approach.gap / dt);
  if (is_single && approach.gap > 0) after = 2 * approach.velocity_after();  // no impulse
  const double push = e > 0 ? 0 : std::max(0.0, -approach.gap * info.m_erp2 / dt);
  row.m_rhs = (after - approach.velocity_after()) * row.m_jacDiagABInv;
  row.m_rhsPenetration = push * row.m_jacDiagABInv;
}

}  // namespace playhouse::arena
