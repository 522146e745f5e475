#pragma once

/// Contacts between convex hulls and the triangles of a static mesh, for Bullet's dispatcher.
///
/// In: a hull and a triangle of a mesh; which edges of the triangle others continue.
/// Out: contacts at all corners of the area in which they touch, along the axis of least penetration.
/// Cost: (1 + faces + 3 edges) projections of the hull, of those that differ in direction; a clipped polygon.
///
/// Replaces Bullet's own algorithm, which finds one point of a triangle per step and others by turning the
/// hull a little: a crate on a mesh shakes and creeps. A hull that goes over an edge between triangles in a
/// plane, or in a hollow, touches the triangle's face, never the edge: nothing stands out there.
/// Source: separating axes with clipped faces (Gregorius, "The separating axis test between convex
/// polyhedra", GDC 2013).

#include <array>

#include "playhouse/arena/physics/bullet.h"

namespace playhouse::arena {

/// Adds the contacts of a hull with a triangle, whose corners are in W, that are nearer than `near`. For the
/// folds of its edges see SurfaceShape::folds().
void meet_triangle(const btConvexHullShape& hull, const btTransform& X_hull,
                   const std::array<btVector3, 3>& corners, const std::array<double, 3>& folds, btScalar near,
                   btManifoldResult& result);

/// For pairs of a hull and a triangle of a SurfaceShape, in this order.
class MeshContacts final : public btCollisionAlgorithmCreateFunc {
 public:
  btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                 const btCollisionObjectWrapper* hull,
                                                 const btCollisionObjectWrapper* triangle) override;
};

}  // namespace playhouse::arena
