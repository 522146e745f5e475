#include "playhouse/arena/physics/bullet_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "playhouse/arena/physics/cylinder_contacts.h"
#include "playhouse/arena/physics/round_solids.h"

namespace playhouse::arena {
namespace {

constexpr double kMargin = 1e-3;    // m, Bullet's collision margin
constexpr double kFlat = 0.02;      // sine of an angle between triangles that counts as none
constexpr double kCoreInset = 0.1;  // of half a body's thickness: of its cores,
constexpr double kDeepest = 0.005;  // m, at most

/// The hull, its faces moved inwards by `inset` where it is four times as thick.
std::unique_ptr<btConvexHullShape> inset_hull(const Hull& hull, const Vec3& center, double inset) {
  Vec3 low = hull.front(), high = hull.front();
  for (const Vec3& p : hull) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vec3 middle = 0.5 * (low + high);
  const auto inwards = [inset](double p, double middle, double low, double high) {
    const double half = 0.5 * (high - low);
    return half > 2 * inset ? middle + (p - middle) * (half - inset) / half : p;
  };
  auto shape = std::make_unique<btConvexHullShape>();
  for (const Vec3& p : hull)
    shape->addPoint(bullet(Vec3{inwards(p.x, middle.x, low.x, high.x), inwards(p.y, middle.y, low.y, high.y),
                                inwards(p.z, middle.z, low.z, high.z)} -
                           center),
                    false);
  shape->setMargin(kMargin);
  shape->recalcLocalAabb();
  return shape;
}

/// Shrinks the hull by the collision margin if possible, so that effective faces are at their true place.
std::unique_ptr<btConvexHullShape> make_hull(const Hull& hull, const Vec3& center) {
  auto shape = inset_hull(hull, center, kMargin);
  shape->initializePolyhedralFeatures();  // for contacts at all corners of touching faces
  return shape;
}

/// The collision shape of a sphere or capsule, and X_FS of its frame in that of the hull.
std::unique_ptr<btConvexShape> round_shape(const Hull& hull, btTransform& X_FS) {
  const RoundSolid solid = round_of(hull);
  X_FS = btTransform(btQuaternion::getIdentity(), bullet(solid.center()));
  if (hull.round == Round::kSphere) return std::make_unique<btSphereShape>(solid.radius);
  const btVector3 axis = bullet(solid.high - solid.low);
  X_FS.setRotation(shortestArcQuat(btVector3(0, 0, 1), axis.normalized()));
  return std::make_unique<btCapsuleShapeZ>(solid.radius, axis.length());
}

double half_thickness(const Hull& hull) {
  Vec3 low = hull.front(), high = hull.front();
  for (const Vec3& p : hull) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return 0.5 * std::min({high.x - low.x, high.y - low.y, high.z - low.z});
}

/// The sine of the angle by which triangle `other` rises above the plane of `row`, beyond its edge i.
double fold(const Triangles& triangles, std::size_t row, std::size_t i, std::size_t other) {
  const auto& corner = triangles.corner[row];
  const Vec3 &a = triangles.p[corner[i]], &b = triangles.p[corner[(i + 1) % 3]];
  const Vec3 along = b - a, normal = cross(along, triangles.p[corner[(i + 2) % 3]] - a);
  double rise = 0, reach = 0;
  for (const std::uint32_t k : triangles.corner[other]) {
    const Vec3 arm = triangles.p[k] - a;
    const Vec3 out = cross(along, arm);  // its distance from the edge, times the edge's length
    if (dot(out, out) <= reach) continue;
    reach = dot(out, out);
    rise = dot(normal, arm) * std::sqrt(dot(along, along) / (dot(normal, normal) * reach));
  }
  return std::fabs(rise) < kFlat ? 0 : rise;
}

/// See SurfaceShape::folds(). Of several triangles beyond an edge, the highest counts.
std::vector<std::array<double, 3>> folds_of(const Triangles& triangles) {
  using Point = std::array<double, 3>;
  std::map<std::pair<Point, Point>, std::vector<std::size_t>> beside;  // edges, to rows of triangles
  const auto point = [&](std::size_t row, std::size_t i) {
    const Vec3& p = triangles.p[triangles.corner[row][i % 3]];
    return Point{p.x, p.y, p.z};
  };
  const auto edge = [&](std::size_t row, std::size_t i) {
    return std::minmax({point(row, i), point(row, i + 1)});
  };
  for (std::size_t row = 0; row < triangles.corner.size(); ++row)
    for (std::size_t i = 0; i < 3; ++i) beside[edge(row, i)].push_back(row);
  std::vector<std::array<double, 3>> folds(triangles.corner.size());
  for (std::size_t row = 0; row < folds.size(); ++row)
    for (std::size_t i = 0; i < 3; ++i) {
      folds[row][i] = -std::numeric_limits<double>::infinity();
      for (const std::size_t other : beside[edge(row, i)])
        if (other != row) folds[row][i] = std::max(folds[row][i], fold(triangles, row, i, other));
    }
  return folds;
}

}  // namespace

ConvexShapes::ConvexShapes(std::span<const Hull> solids, const Vec3& center) {
  std::vector<btTransform> poses;
  for (const Hull& hull : solids) {
    btTransform& pose = poses.emplace_back(btTransform::getIdentity());
    if (hull.round == Round::kNot) {
      solids_.push_back(make_hull(hull, center));
      continue;
    }
    if (hull.round == Round::kCylinder) {
      solids_.push_back(std::make_unique<CylinderShape>(hull, center, kMargin));
      continue;
    }
    solids_.push_back(round_shape(hull, pose));
    pose.setOrigin(pose.getOrigin() - bullet(center));
  }
  if (solids_.size() == 1 && poses.front() == btTransform::getIdentity()) return;
  compound_ = std::make_unique<btCompoundShape>();
  for (std::size_t i = 0; i < solids_.size(); ++i) compound_->addChildShape(poses[i], solids_[i].get());
  compound_->getDynamicAabbTree()->optimizeTopDown();
}

Cores::Cores(std::span<const Hull> solids, const Vec3& center) {
  double thin = 1e300;
  for (const Hull& hull : solids) thin = std::min(thin, half_thickness(hull));
  inset_ = std::clamp(kCoreInset * thin, kMargin, kDeepest);
  for (const Hull& hull : solids) hulls_.push_back(inset_hull(hull, center, inset_ + kMargin));
}

SurfaceShape::SurfaceShape(const Triangles& triangles) : folds_(folds_of(triangles)) {
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
  shape_->setUserPointer(this);
}

std::unique_ptr<btRigidBody> make_body(double mass, btCollisionShape& shape, const ContactSurface& surface) {
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
