#pragma once

/// Contacts of cylinders with the ground, triangle meshes, polyhedra and each other, for Bullet's dispatcher.
///
/// In: a cylinder as a polyhedron, and what is near.
/// Out: the contacts of that polyhedron, turned about its axis so that one of its edges is where the cylinder
///   is nearest: it lies and rolls on a line of its own, and leans on a point of its rim. Of those with one
///   normal at most four, around a large area; of more than four normals those of the deepest.
/// Cost: that of the polyhedron's contacts; with a polyhedron a product for each of its faces.
///
/// Of a polyhedron the face counts above which the cylinder is highest; a disc that is nearly parallel to it
/// bears at the corners of what the two share. Two cylinders beside each other touch
/// at both ends of a line; if their axes cross, one has a flat side towards the other, lifted to where it is
/// round. Contacts are found anew in each step, and only near: those of before have rolled on, and those of
/// the neighbouring edges are none of the cylinder.

#include "playhouse/arena/physics/bullet.h"

namespace playhouse::arena {

/// A cylinder as a polyhedron with a line of corners along its side, relative to `center`.
class CylinderShape final : public btConvexHullShape {
 public:
  CylinderShape(const Hull& cylinder, const Vec3& center, double margin);

  /// X, turned about the axis so that the line of corners is on the side of `toward` (in W). X if that is
  /// along the axis.
  btTransform turned(const btTransform& X, const btVector3& toward) const;
  /// Likewise, so that a flat side between two lines is there.
  btTransform with_flat_side(const btTransform& X, const btVector3& toward) const;
  const btVector3& middle() const { return middle_; }
  const btVector3& axis() const { return axis_; }  // unit
  double radius() const { return radius_; }
  double half() const { return half_; }

 private:
  btTransform turned(const btTransform& X, const btVector3& toward, const btVector3& from) const;

  btVector3 middle_, axis_, side_;  // side: from the axis to the line of corners; unit
  double radius_ = 0, half_ = 0;    // m
};

/// For pairs of a CylinderShape and a plane, a SurfaceShape, a btConvexHullShape or another CylinderShape, or
/// in the order `cylinder_second`.
class CylinderContacts final : public btCollisionAlgorithmCreateFunc {
 public:
  explicit CylinderContacts(bool cylinder_second) { m_swapped = cylinder_second; }
  btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                 const btCollisionObjectWrapper* first,
                                                 const btCollisionObjectWrapper* second) override;
};

}  // namespace playhouse::arena
