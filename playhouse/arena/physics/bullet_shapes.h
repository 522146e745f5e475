#pragma once

/// Collision shapes and rigid bodies of Bullet.
///
/// In: hulls, or the triangles of a static mesh.
/// Out: collision shapes; the folds at edges of triangles.
/// Cost: once for the hulls of a body; of a mesh, a hierarchy over its triangles and a search for those
///   beyond each edge.

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "playhouse/arena/physics/bullet.h"
#include "playhouse/arena/triangles.h"

namespace playhouse::arena {

/// Convex solids, polyhedra and round ones, as one collision shape, relative to `center`.
class ConvexShapes {
 public:
  ConvexShapes(std::span<const Hull> solids, const Vec3& center);
  btCollisionShape& shape() const {
    if (compound_) return *compound_;
    return *solids_.front();
  }

 private:
  std::vector<std::unique_ptr<btConvexShape>> solids_;
  std::unique_ptr<btCompoundShape> compound_;  // if there is more than one, or one that has a pose
};

/// Smaller copies of convex solids, relative to `center`: what of a fast body stops at obstacles, so that it
/// may slide along seams of a floor, and overlaps with what it hits.
class Cores {
 public:
  Cores(std::span<const Hull> solids, const Vec3& center);
  std::span<const std::unique_ptr<btConvexHullShape>> hulls() const { return hulls_; }
  /// Distance of the cores' faces from those of the solids.  [m]
  double inset() const { return inset_; }

 private:
  std::vector<std::unique_ptr<btConvexHullShape>> hulls_;
  double inset_ = 0;
};

/// A static triangle mesh.
class SurfaceShape {
 public:
  explicit SurfaceShape(const Triangles& triangles);
  btCollisionShape& shape() const { return *shape_; }
  /// For each edge of a triangle, from its corner of that number to the next: the sine of the angle by which
  /// the triangle beyond rises above this one's plane, 0 if it continues it; -infinity if there is none.
  const std::array<double, 3>& folds(int triangle) const {
    return folds_[static_cast<std::size_t>(triangle)];
  }

 private:
  std::vector<std::array<double, 3>> folds_;
  std::vector<double> p_;
  std::vector<int> rows_;
  btTriangleIndexVertexArray mesh_;
  std::unique_ptr<btBvhTriangleMeshShape> shape_;
};

/// A body at the origin. `mass` in kg; 0: static or kinematic.
std::unique_ptr<btRigidBody> make_body(double mass, btCollisionShape& shape, const ContactSurface& surface);

}  // namespace playhouse::arena
