#pragma once

/// Where convex hulls touch the ground, for Bullet's dispatcher.
///
/// In: a hull above, on or in a plane.
/// Out: contacts at all corners that are near enough, of which Bullet keeps the four that hold it best.
/// Cost: a product for each corner.
///
/// In place of Bullet's own, which finds one corner in each step and others by tilting the body about its own
/// axes: of a box that lies on its side those of one edge, about which gravity turns it then. What an earlier
/// step found is forgotten between ticks (Physics::forget()).

#include <btBulletDynamicsCommon.h>

namespace playhouse::arena {

/// Of hulls as the first body and planes as the second, or the other way round.
class GroundContacts final : public btCollisionAlgorithmCreateFunc {
 public:
  explicit GroundContacts(bool plane_first) { m_swapped = plane_first; }
  btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                 const btCollisionObjectWrapper* first,
                                                 const btCollisionObjectWrapper* second) override;
};

}  // namespace playhouse::arena
