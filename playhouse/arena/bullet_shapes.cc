#include "playhouse/arena/bullet_shapes.h"

#include <algorithm>

namespace playhouse::arena {
namespace {

constexpr double kMargin = 1e-3;  // m, Bullet's collision margin

/// Shrinks the hull by the collision margin if possible, so that the effective faces are at their true place.
std::unique_ptr<btConvexHullShape> make_hull(const Hull& hull, const Vec3& center) {
  Vec3 low = hull.front(), high = hull.front();
  for (const Vec3& p : hull) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vec3 middle = 0.5 * (low + high);
  const auto inwards = [](double p, double middle, double low, double high) {
    const double half = 0.5 * (high - low);
    return half > 2 * kMargin ? middle + (p - middle) * (half - kMargin) / half : p;
  };
  auto shape = std::make_unique<btConvexHullShape>();
  for (const Vec3& p : hull)
    shape->addPoint(bullet(Vec3{inwards(p.x, middle.x, low.x, high.x), inwards(p.y, middle.y, low.y, high.y),
                                inwards(p.z, middle.z, low.z, high.z)} -
                           center),
                    false);
  shape->setMargin(kMargin);
  shape->recalcLocalAabb();
  shape->initializePolyhedralFeatures();  // for contacts at all corners of touching faces
  return shape;
}

}  // namespace

ConvexShapes::ConvexShapes(std::span<const Hull> solids, const Vec3& center) {
  for (const Hull& hull : solids) hulls_.push_back(make_hull(hull, center));
  if (hulls_.size() == 1) return;
  compound_ = std::make_unique<btCompoundShape>();
  for (const auto& hull : hulls_) compound_->addChildShape(btTransform::getIdentity(), hull.get());
  compound_->getDynamicAabbTree()->optimizeTopDown();
}

SurfaceShape::SurfaceShape(const Triangles& triangles) {
  for (const Vec3& v : triangles.p) p_.insert(p_.end(), {v.x, v.y, v.z});
  for (const auto& corner : triangles.corner)
    for (const std::uint32_t row : corner) rows_.push_back(static_cast<int>(row));
  btIndexedMesh part;
  part.m_numTriangles = static_cast<int>(triangles.corner.size());
  part.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(rows_.data());
  part.m_triangleIndexStride = 3 * sizeof(int);
  part.m_numVertices = static_cast<int>(triangles.p.size());
  part.m_vertexBase = reinterpret_cast<const unsigned char*>(p_.data());
  part.m_vertexStride = 3 * sizeof(double);
  part.m_indexType = PHY_INTEGER;
  part.m_vertexType = PHY_DOUBLE;
  mesh_.addIndexedMesh(part, PHY_INTEGER);
  shape_ = std::make_unique<btBvhTriangleMeshShape>(&mesh_, true);
  shape_->setMargin(kMargin);
}

std::unique_ptr<btRigidBody> make_body(double mass, btCollisionShape& shape, const Surface& surface) {
  btVector3 inertia(0, 0, 0);
  if (mass > 0) shape.calculateLocalInertia(mass, inertia);
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
  info.m_friction = surface.friction;
  info.m_restitution = surface.restitution;
  auto body = std::make_unique<btRigidBody>(info);
  if (surface.has_grain()) body->setAnisotropicFriction({surface.share_x, surface.share_y, 1});
  body->setActivationState(DISABLE_DEACTIVATION);
  return body;
}

}  // namespace playhouse::arena
