#pragma once

/// Collision shapes and rigid bodies of Bullet.

#include <memory>
#include <span>
#include <vector>

#include "playhouse/arena/bullet.h"
#include "playhouse/arena/triangles.h"

namespace playhouse::arena {

/// Convex solids as one collision shape, relative to `center`.
class ConvexShapes {
 public:
  ConvexShapes(std::span<const Hull> solids, const Vec3& center);
  btCollisionShape& shape() const {
    if (compound_) return *compound_;
    return *hulls_.front();
  }

 private:
  std::vector<std::unique_ptr<btConvexHullShape>> hulls_;
  std::unique_ptr<btCompoundShape> compound_;  // if there is more than one
};

/// A static triangle mesh.
class SurfaceShape {
 public:
  explicit SurfaceShape(const Triangles& triangles);
  btCollisionShape& shape() const { return *shape_; }

 private:
  std::vector<double> p_;
  std::vector<int> rows_;
  btTriangleIndexVertexArray mesh_;
  std::unique_ptr<btBvhTriangleMeshShape> shape_;
};

/// A body at the origin. `mass` in kg; 0: static or kinematic.
std::unique_ptr<btRigidBody> make_body(double mass, btCollisionShape& shape, const Surface& surface);

}  // namespace playhouse::arena
