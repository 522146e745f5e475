#include "playhouse/arena/physics/cylinder_contacts.h"

#include <BulletCollision/CollisionShapes/btConvexPolyhedron.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "playhouse/arena/physics/bullet_shapes.h"
#include "playhouse/arena/physics/mesh_contacts.h"
#include "playhouse/arena/physics/pair_algorithm.h"
#include "playhouse/arena/physics/round_solids.h"

namespace playhouse::arena {
namespace {

constexpr double kNearShare = 0.01;  // of the radius: the next edge is at 0.034 of it
constexpr double kStands2 = 2.5e-5;  // squared sine of the angle between axis and normal: less, and it stands
constexpr double kAboveDisc =
    0.995;  // cosine of the angle between axis and normal: more, and a disc is above a face
constexpr double kOuter = -1;  // the fold of an edge of a convex solid
constexpr double kAlikeNormals =
    0.99;                         // cosine of the angle between normals of contacts that support each other
constexpr double kAsDeep = 1e-4;  // m between contacts that are as deep
constexpr std::size_t kMostNormals = 4;  // normals that differ
constexpr double kParallel2 = 0.01;      // squared sine of the angle between axes
constexpr int kSteps = 8;                // between two axes
constexpr double kCoaxial = 1e-9;        // m between points of two axes that have no direction
// Half the angle between two edges.
constexpr double kCosHalf = 0.99144486137381041, kSinHalf = 0.13052619222005159;

struct CylinderTouch {
  btVector3 normal, p;  // of the other, in W
  btScalar distance;
};

/// What of a convex polygon is behind the plane through p with normal n.
std::vector<btVector3> cut_off(const std::vector<btVector3>& polygon, const btVector3& p,
                               const btVector3& n) {
  std::vector<btVector3> left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const btVector3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const btScalar over_a = n.dot(a - p), over_b = n.dot(b - p);
    if (over_a <= 0) left.push_back(a);
    if ((over_a < 0 && over_b > 0) || (over_a > 0 && over_b < 0))
      left.push_back(a + (b - a) * (over_a / (over_a - over_b)));
  }
  return left;
}

/// Keeps all contacts, where Bullet's would keep four of them.
class Collected final : public btManifoldResult {
 public:
  void addContactPoint(const btVector3& normal, const btVector3& p, btScalar distance) override {
    touches.push_back({normal, p, distance});
  }
  std::vector<CylinderTouch> touches;
};

/// Four of these or fewer, of one normal, around as large an area as is simple to find. The first is one of
/// the deepest, the same one where several are as deep: what stands does not rock from one to the next.
std::vector<CylinderTouch> around(const std::vector<CylinderTouch>& all) {
  if (all.size() <= 4) return all;
  const auto best = [&](const auto& score) {
    const CylinderTouch* chosen = &all.front();
    for (const CylinderTouch& touch : all)
      if (score(touch) > score(*chosen) + SIMD_EPSILON) chosen = &touch;
    return *chosen;
  };
  btScalar deepest = all.front().distance;
  for (const CylinderTouch& touch : all) deepest = btMin(deepest, touch.distance);
  const CylinderTouch a = *std::ranges::find_if(
      all, [&](const CylinderTouch& touch) { return touch.distance <= deepest + kAsDeep; });
  const CylinderTouch b = best([&](const CylinderTouch& touch) { return touch.p.distance2(a.p); });
  const btVector3 across = (b.p - a.p).cross(a.normal);
  const auto aside = [&](const CylinderTouch& touch) { return across.dot(touch.p - a.p); };
  const CylinderTouch left = best(aside),
                      right = best([&](const CylinderTouch&touch) { return -aside(touch); });
  std::vector<CylinderTouch> few{a, b};
  for (const CylinderTouch& touch : {left, right})
    if (touch.p != a.p && touch.p != b.p) few.push_back(touch);
  return few;
}

btVector3 normal_of(const btFace& face) {
  return {face.m_plane[0], face.m_plane[1], face.m_plane[2]};
}

/// The face of a hull above which a cylinder is highest.
const btFace& nearest_face(const btConvexPolyhedron& hull, const btTransform& X_WH,
                           const CylinderShape& cylinder, const btTransform& X_WC) {
  const btTransform X_HC = X_WH.inverse() * X_WC;
  const btVector3 middle = X_HC * cylinder.middle(), axis = X_HC.getBasis() * cylinder.axis();
  btScalar highest = -BT_LARGE_FLOAT;
  int best = 0;
  for (int i = 0; i < hull.m_faces.size(); ++i) {
    const btFace& face = hull.m_faces[i];
    const btVector3 n = normal_of(face);
    const btScalar along = n.dot(axis), across = std::sqrt(btMax(btScalar(0), 1 - along * along));
    const btScalar over = n.dot(middle - hull.m_vertices[face.m_indices[0]]) -
                          cylinder.half() * std::fabs(along) - cylinder.radius() * across;
    if (over > highest) highest = over, best = i;
  }
  return hull.m_faces[best];
}

btVector3 nearest_on_axis(const CylinderShape& cylinder, const btTransform& X, const btVector3& p) {
  const btVector3 axis = X.getBasis() * cylinder.axis(), middle = X * cylinder.middle();
  const btScalar half = cylinder.half();
  return middle + axis * btClamped(axis.dot(p - middle), -half, half);
}

/// From the axis of one cylinder to that of another: from each to the nearest point of the other, again and
/// again.
btVector3 way_between(const CylinderShape& from, const btTransform& X_from, const CylinderShape& to,
                      const btTransform& X_to) {
  btVector3 begin = X_from * from.middle(), end = X_to * to.middle();
  for (int i = 0; i < kSteps; ++i) {
    end = nearest_on_axis(to, X_to, begin);
    begin = nearest_on_axis(from, X_from, end);
  }
  return end - begin;
}

/// A unit vector across an axis, the same one each time.
btVector3 across_axis(const btVector3& axis) {
  btVector3 one, other;
  btPlaneSpace1(axis.normalized(), one, other);
  return one;
}

/// Finds the contacts of a cylinder.
class CylinderTrial {
 public:
  CylinderTrial(const CylinderShape& cylinder, const btTransform& X, btScalar near)
      : cylinder_(cylinder), X_(X), near_(near) {}

  void meet(const btCollisionShape& other, const btTransform& X) {
    switch (other.getShapeType()) {
      case STATIC_PLANE_PROXYTYPE:
        return meet_plane(static_cast<const btStaticPlaneShape&>(other), X);
      case TRIANGLE_MESH_SHAPE_PROXYTYPE:
        return meet_mesh(static_cast<const btConcaveShape&>(other), X);
      case CUSTOM_POLYHEDRAL_SHAPE_TYPE:
        return meet_cylinder(static_cast<const CylinderShape&>(other), X);
      default:
        return meet_hull(static_cast<const btConvexHullShape&>(other), X, 0);
    }
  }
  const std::vector<CylinderTouch>& touches() const { return found_.touches; }

 private:
  void meet_plane(const btStaticPlaneShape& plane, const btTransform& X) {
    const btVector3 normal = X.getBasis() * plane.getPlaneNormal();
    const btScalar height = normal.dot(X.getOrigin()) + plane.getPlaneConstant() + cylinder_.getMargin();
    const btTransform turned = cylinder_.turned(X_, -normal);
    for (int i = 0; i < cylinder_.getNumPoints(); ++i) {
      const btVector3 p = turned * cylinder_.getScaledPoint(i);
      const btScalar over = normal.dot(p) - height;
      if (over < near_) found_.addContactPoint(normal, p - normal * (over + cylinder_.getMargin()), over);
    }
  }
  void meet_mesh(const btConcaveShape& mesh, const btTransform& X) {
    struct Each final : btTriangleCallback {
      CylinderTrial& trial;
      const SurfaceShape& surface;
      const btTransform& X;
      Each(CylinderTrial& trial, const SurfaceShape& surface, const btTransform& X)
          : trial(trial), surface(surface), X(X) {}
      void processTriangle(btVector3* p, int, int row) override {
        trial.meet_corners({X * p[0], X * p[1], X * p[2]}, surface.folds(row));
      }
    } each{*this, *static_cast<const SurfaceShape*>(mesh.getUserPointer()), X};
    btVector3 low, high;
    cylinder_.getAabb(X.inverse() * X_, low, high);
    const btVector3 near(near_, near_, near_);
    mesh.processAllTriangles(&each, low - near, high + near);
  }
  void meet_corners(const std::array<btVector3, 3>& corners, const std::array<double, 3>& folds) {
    const btVector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const bool is_front = normal.dot(X_ * cylinder_.middle() - corners[0]) >= 0;
    meet_triangle(cylinder_, cylinder_.turned(X_, is_front ? -normal : normal), corners, folds, near_,
                  found_);
  }
  /// Unless they are beside each other, the other one with a flat side towards this one, at the distance of
  /// its round side.
  void meet_cylinder(const CylinderShape& other, const btTransform& X) {
    if (is_beside(other, X)) return meet_beside(other, X);
    const btVector3 way = way_between(other, X, cylinder_, X_);
    meet_hull(other, other.with_flat_side(X, way), (1 - kCosHalf) * other.radius());
  }
  /// True if the axes are nearly parallel, and the two are farther apart across than along them.
  bool is_beside(const CylinderShape& other, const btTransform& X) const {
    const btVector3 axis = X_.getBasis() * cylinder_.axis(),
                    way = X * other.middle() - X_ * cylinder_.middle();
    if (axis.cross(X.getBasis() * other.axis()).length2() > kParallel2) return false;
    const btScalar along = axis.dot(way);
    const btScalar apart_along = btFabs(along) - cylinder_.half() - other.half();
    return (way - axis * along).length() - cylinder_.radius() - other.radius() > apart_along;
  }
  /// At both ends of the line on which two cylinders lie beside each other.
  void meet_beside(const CylinderShape& other, const btTransform& X) {
    const btVector3 half = X.getBasis() * other.axis() * other.half(), middle = X * other.middle();
    for (const btVector3& end : {middle - half, middle + half}) {
      const btVector3 p = nearest_on_axis(cylinder_, X_, end), q = nearest_on_axis(other, X, p);
      const btVector3 arm = p - q;
      const btScalar apart = arm.length(), distance = apart - cylinder_.radius() - other.radius();
      const btVector3 normal = apart > kCoaxial ? arm / apart : across_axis(half);
      if (distance < near_) found_.addContactPoint(normal, q + normal * other.radius(), distance);
    }
  }
  /// A side across the axis of a cylinder is `lift` farther out.
  void meet_hull(const btConvexHullShape& shape, const btTransform& X_WH, double lift) {
    const btConvexPolyhedron& hull = *shape.getConvexPolyhedron();
    const btFace& face = nearest_face(hull, X_WH, cylinder_, X_);
    const btVector3 normal = X_WH.getBasis() * normal_of(face);
    const int count = face.m_indices.size();
    const bool is_side = count == 4;
    const btVector3 out = normal * (shape.getMargin() + (is_side ? lift : 0));
    const btTransform turned = cylinder_.turned(X_, -normal);
    const auto corner = [&](int i) { return X_WH * hull.m_vertices[face.m_indices[i]] + out; };
    const btScalar level = normal.dot(X_.getBasis() * cylinder_.axis());
    if (btFabs(level) > kAboveDisc) {
      std::vector<btVector3> corners;
      for (int i = 0; i < count; ++i) corners.push_back(corner(i));
      return meet_disc(corners, normal, turned, level > 0);
    }
    for (int i = 1; i + 1 < count; ++i)
      meet_triangle(cylinder_, turned, {corner(0), corner(i), corner(i + 1)},
                    {i == 1 ? kOuter : 0, kOuter, i + 2 == count ? kOuter : 0}, near_, found_);
  }

  /// The low or high disc above a face that is nearly parallel: at the corners of what they share.
  void meet_disc(const std::vector<btVector3>& face, const btVector3& normal, const btTransform& turned,
                 bool is_low) {
    const int half = cylinder_.getNumPoints() / 2;
    std::vector<btVector3> shared;
    for (int i = 0; i < half; ++i) shared.push_back(turned * cylinder_.getScaledPoint(is_low ? i : half + i));
    btVector3 middle(0, 0, 0);
    for (const btVector3& p : face) middle += p / static_cast<btScalar>(face.size());
    for (std::size_t i = 0; i < face.size(); ++i) {
      btVector3 out = (face[(i + 1) % face.size()] - face[i]).cross(normal);
      if (out.dot(middle - face[i]) > 0) out = -out;
      shared = cut_off(shared, face[i], out);
    }
    for (const btVector3& p : shared) {
      const btScalar over = normal.dot(p - face[0]), distance = over - cylinder_.getMargin();
      if (distance < near_) found_.addContactPoint(normal, p - normal * over, distance);
    }
  }

  const CylinderShape& cylinder_;
  const btTransform& X_;
  const btScalar near_;
  Collected found_;
};

class CylinderAlgorithm final : public PairAlgorithm<kMostNormals> {
 public:
  using PairAlgorithm::PairAlgorithm;

 private:
  void meet(const btCollisionObjectWrapper& round, const btCollisionObjectWrapper& other,
            const Manifolds& manifolds, btManifoldResult& result) const override {
    const auto& cylinder = static_cast<const CylinderShape&>(*round.getCollisionShape());
    const btScalar near = btMin(manifolds[0]->getContactBreakingThreshold(), kNearShare * cylinder.radius());
    CylinderTrial trial(cylinder, round.getWorldTransform(), near);
    trial.meet(*other.getCollisionShape(), other.getWorldTransform());
    std::vector<CylinderTouch> left = trial.touches();
    for (btPersistentManifold* contacts : manifolds) {
      contacts->clearManifold();
      if (left.empty()) continue;
      result.setPersistentManifold(contacts);
      std::vector<CylinderTouch> alike;
      const btVector3 normal = std::ranges::min_element(left, {}, &CylinderTouch::distance)->normal;
      std::erase_if(left, [&](const CylinderTouch& touch) {
        if (touch.normal.dot(normal) < kAlikeNormals) return false;
        alike.push_back(touch);
        return true;
      });
      for (const CylinderTouch& touch : around(alike))
        result.addContactPoint(touch.normal, touch.p, touch.distance);
    }
  }
};

}  // namespace

CylinderShape::CylinderShape(const Hull& cylinder, const Vec3& center, double margin) {
  const RoundSolid solid = round_of(cylinder);
  const btVector3 along = bullet(solid.high - solid.low);
  middle_ = bullet(solid.center() - center);
  half_ = 0.5 * along.length();
  axis_ = along.normalized();
  radius_ = solid.radius;
  side_ = bullet(cylinder.front() - solid.low).normalized();
  const double r = radius_ > 2 * margin ? radius_ - margin : radius_,
               half = half_ > 2 * margin ? half_ - margin : half_;
  for (const Vec3& corner : cylinder) {
    const btVector3 arm = bullet(corner - center) - middle_;
    const btVector3 out = arm - axis_ * arm.dot(axis_);
    addPoint(middle_ + out * (r / radius_) + axis_ * (arm.dot(axis_) > 0 ? half : -half), false);
  }
  setMargin(margin);
  recalcLocalAabb();
  initializePolyhedralFeatures();
  m_shapeType = CUSTOM_POLYHEDRAL_SHAPE_TYPE;
}

btTransform CylinderShape::turned(const btTransform& X, const btVector3& toward,
                                  const btVector3& from) const {
  btVector3 side = toward * X.getBasis();
  const btScalar length2 = side.length2();
  side -= axis_ * axis_.dot(side);
  if (side.length2() <= kStands2 * length2) return X;
  side.normalize();
  const auto frame = [this](const btVector3& x) {
    const btVector3 y = axis_.cross(x);
    return btMatrix3x3(x.x(), y.x(), axis_.x(), x.y(), y.y(), axis_.y(), x.z(), y.z(), axis_.z());
  };
  const btMatrix3x3 turn = frame(side) * frame(from).transpose();
  return btTransform(X.getBasis() * turn, X * (middle_ - turn * middle_));
}

btTransform CylinderShape::turned(const btTransform& X, const btVector3& toward) const {
  return turned(X, toward, side_);
}

btTransform CylinderShape::with_flat_side(const btTransform& X, const btVector3& toward) const {
  return turned(X, toward, side_ * kCosHalf + axis_.cross(side_) * kSinHalf);
}

btCollisionAlgorithm* CylinderContacts::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                                 const btCollisionObjectWrapper* first,
                                                                 const btCollisionObjectWrapper* second) {
  return make_pair_algorithm<CylinderAlgorithm>(info, first, second, m_swapped);
}

}  // namespace playhouse::arena
