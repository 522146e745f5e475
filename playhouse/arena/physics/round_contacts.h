#pragma once

/// Contacts of spheres and capsules with the ground, triangle meshes, polyhedra and each other, for Bullet's
/// dispatcher.
///
/// In: a round solid, the points within a radius of an axis, and what is near.
/// Out: contacts where that is nearest to the ends of the axis, and to the points of the axis that are
///   nearest to an edge; of those with one normal the two farthest from each other, at most four.
/// Cost: for each end, the distance to each near face; for a capsule, also for up to three points in each of
///   32 parts of its axis, and a product for each near edge.
///
/// A point of a mesh is a contact if no other triangle there is nearer: nothing is met twice, and what rolls
/// over an edge between two triangles in a plane or in a hollow does not touch the edge.
/// Contacts are found anew in each step: those of before have rolled on.
/// Source: distances of points, segments and polygons (Ericson, "Real-time collision detection", 2005).

#include "playhouse/arena/physics/bullet.h"

namespace playhouse::arena {

/// For pairs of a btSphereShape or btCapsuleShapeZ and another shape, or in the order `round_second`.
class RoundContacts final : public btCollisionAlgorithmCreateFunc {
 public:
  explicit RoundContacts(bool round_second) { m_swapped = round_second; }
  btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                 const btCollisionObjectWrapper* first,
                                                 const btCollisionObjectWrapper* second) override;
};

}  // namespace playhouse::arena
