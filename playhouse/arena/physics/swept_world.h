#pragma once

/// SweptWorld: Bullet's world, in which fast bodies do not pass through others.
///
/// In: the motion of bodies in a step, after contacts are solved.
/// Out: a body that moves by more than a fifth of half its thickness, or 1 cm, goes only until it touches
///   something; the contacts of the next step stop it or throw it back.
/// Cost: nothing for slower bodies; for a fast one, a query of the broad phase for its path, and some
///   runs of GJK for each solid there.
///
/// A path is straight: rotations count for the ground only. No result depends on the order of bodies.
/// Source: conservative advancement (Mirtich, "Impulse-based dynamic simulation of rigid body systems",
///   1996).

#include "playhouse/arena/physics/bullet.h"

namespace playhouse::arena {

struct Moving;

class SweptWorld final : public btDiscreteDynamicsWorld {
 public:
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

 private:
  /// A body that goes a share of its way.
  struct Stop {
    btRigidBody* body;
    btTransform X;
    double share;
  };
  void integrateTransforms(btScalar dt) override;
  double free_share(const Moving& moving, const btRigidBody& body, double dt);

  btAlignedObjectArray<Stop> stops_;  // scratch
};

}  // namespace playhouse::arena
