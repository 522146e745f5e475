#pragma once

/// Contacts between convex hulls and the ground plane, for Bullet's dispatcher.
///
/// In: a hull near a plane.
/// Out: contacts at all corners within the contact distance; Bullet's manifold keeps the best four.
/// Cost: a dot product for each corner.
///
/// Replaces Bullet's own algorithm, which adds one corner per step and finds others by perturbing the
/// rotation about the body's axes: for a box on its side it finds one edge only, about which gravity then
/// tips the box. Contacts cannot accumulate over ticks here: Physics::clear_contacts() drops the manifolds.

#include <btBulletDynamicsCommon.h>

namespace playhouse::arena {

/// For pairs of a hull and a plane; `plane_first` for the swapped order.
class GroundContacts final : public btCollisionAlgorithmCreateFunc {
 public:
  explicit GroundContacts(bool plane_first) { m_swapped = plane_first; }
  btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                 const btCollisionObjectWrapper* first,
                                                 const btCollisionObjectWrapper* second) override;
};

}  // namespace playhouse::arena
