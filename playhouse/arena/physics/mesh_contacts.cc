#include "playhouse/arena/physics/mesh_contacts.h"

#include <BulletCollision/CollisionShapes/btConvexPolyhedron.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>

#include <array>
#include <cmath>
#include <new>
#include <utility>

#include "playhouse/arena/physics/bullet_shapes.h"

namespace playhouse::arena {
namespace {

constexpr double kParallel = 1e-6;  // squared sine of the angle between edges without an axis across
constexpr double kAlong = 1e-3;     // sine of the angle between an edge and what touches all of it
constexpr double kPrefer = 1e-4;    // m that an axis of edges must be better than one of faces

using Polygon = btAlignedObjectArray<btVector3>;

/// Keeps what of a polygon is behind the plane through p with normal n. New corners get `mark` as their w.
void clip(Polygon& polygon, Polygon& scratch, const btVector3& p, const btVector3& n, btScalar mark) {
  scratch.resize(0);
  for (int i = 0; i < polygon.size(); ++i) {
    const btVector3 &a = polygon[i], &b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const btScalar over_a = n.dot(a - p), over_b = n.dot(b - p);
    if (over_a <= 0) scratch.push_back(a);
    if ((over_a < 0 && over_b > 0) || (over_a > 0 && over_b < 0)) {
      scratch.push_back(a + (b - a) * (over_a / (over_a - over_b)));
      scratch[scratch.size() - 1].setW(mark);
    }
  }
  std::swap(polygon, scratch);
}

/// A hull and a triangle, in W. Axes point from the triangle to the hull.
class Pair {
 public:
  Pair(const btConvexHullShape& hull, const btTransform& X, const std::array<btVector3, 3>& corners,
       const std::array<double, 3>& folds)
      : hull_(*hull.getConvexPolyhedron()), X_(X), margin_(hull.getMargin()), folds_(folds), t_(corners) {
    normal_ = (t_[1] - t_[0]).cross(t_[2] - t_[0]);
    const btScalar length = normal_.length();
    is_flat_ = length < SIMD_EPSILON;
    if (is_flat_) return;
    normal_ /= length;
    center_ = X_ * hull_.m_localCenter;
    is_front_ = normal_.dot(center_ - t_[0]) >= 0;
    if (!is_front_) normal_ = -normal_;
  }

  /// Adds the contacts nearer than `near`.
  void meet(btManifoldResult& result, btScalar near) {
    if (is_flat_ || !find_axis(near)) return;
    if (kind_ != Kind::kTriangle && !stands_out()) kind_ = Kind::kTriangle;
    if (kind_ == Kind::kTriangle) return meet_triangle(result, near);
    if (kind_ == Kind::kHull) return meet_hull(result, near);
    meet_edges(result);
  }

 private:
  enum class Kind { kTriangle, kHull, kEdges };

  /// Distance of the two along an axis, negative if they overlap.
  btScalar distance(const btVector3& axis) const {
    const btVector3 in_hull = axis * X_.getBasis();
    btScalar low = BT_LARGE_FLOAT;
    for (int i = 0; i < hull_.m_vertices.size(); ++i) low = btMin(low, in_hull.dot(hull_.m_vertices[i]));
    const btScalar high = btMax(axis.dot(t_[0]), btMax(axis.dot(t_[1]), axis.dot(t_[2])));
    return low + axis.dot(X_.getOrigin()) - high - margin_;
  }

  /// Finds the axis of the largest distance. False if that is not near.
  bool find_axis(btScalar near) {
    best_ = distance(normal_);
    if (best_ > near) return false;
    for (int i = 0; i < hull_.m_faces.size(); ++i) {
      const btVector3 axis = -face_normal(i);
      if (!try_axis(axis, 0, near)) return false;
      if (axis_ == axis && kind_ == Kind::kHull) face_ = i;
    }
    for (int i = 0; i < hull_.m_uniqueEdges.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const btVector3 edge = X_.getBasis() * hull_.m_uniqueEdges[i], side = t_[(k + 1) % 3] - t_[k];
        btVector3 axis = edge.cross(side);
        const btScalar length2 = axis.length2();
        if (length2 <= kParallel * side.length2()) continue;
        axis /= btSqrt(length2);
        if (axis.dot(center_ - t_[k]) < 0) axis = -axis;
        if (!try_axis(axis, kPrefer, near)) return false;
        if (axis_ == axis && kind_ == Kind::kEdges) edge_ = edge, side_ = k;
      }
    return true;
  }

  /// Takes an axis if it is better. False if the two are apart along it.
  bool try_axis(const btVector3& axis, btScalar penalty, btScalar near) {
    const btScalar now = distance(axis);
    if (now > near) return false;
    if (now <= best_ + kPrefer + penalty) return true;
    best_ = now;
    axis_ = axis;
    kind_ = penalty > 0 ? Kind::kEdges : Kind::kHull;
    return true;
  }

  /// True if the part of the triangle that is first along the axis is not surrounded by others.
  bool stands_out() const {
    btScalar high = -BT_LARGE_FLOAT;
    for (const btVector3& t : t_) high = btMax(high, axis_.dot(t));
    std::array<bool, 3> is_first{};
    for (int i = 0; i < 3; ++i)
      is_first[i] = axis_.dot(t_[i]) > high - kAlong * (t_[(i + 1) % 3] - t_[i]).length();
    for (int i = 0; i < 3; ++i) {
      const int next = (i + 1) % 3;
      const bool is_edge = is_first[i] && is_first[next];
      const bool is_corner = !is_edge && (is_first[i] || is_first[next]);
      if ((is_edge || (is_corner && count(is_first) == 1)) && is_sharp(i)) return true;
    }
    return false;
  }
  static int count(const std::array<bool, 3>& set) { return set[0] + set[1] + set[2]; }
  bool is_sharp(int edge) const {
    return is_front_ ? folds_[edge] < 0 : folds_[edge] > 0 || std::isinf(folds_[edge]);
  }

  btVector3 face_normal(int face) const {
    const btScalar* plane = hull_.m_faces[face].m_plane;
    return X_.getBasis() * btVector3(plane[0], plane[1], plane[2]);
  }
  Polygon corners_of(int face) const {
    Polygon corners;
    const auto& rows = hull_.m_faces[face].m_indices;
    for (int i = 0; i < rows.size(); ++i) {
      corners.push_back(X_ * hull_.m_vertices[rows[i]]);
      corners[i].setW(0);
    }
    return corners;
  }
  bool is_corner(const btVector3& p) const {
    constexpr double kSame = 1e-12;  // m^2
    return p.distance2(t_[0]) < kSame || p.distance2(t_[1]) < kSame || p.distance2(t_[2]) < kSame;
  }

  /// At the corners of the hull's face within the triangle. Where the face goes on beyond an edge that others
  /// continue is none: it would take the place of a corner among Bullet's four.
  void meet_triangle(btManifoldResult& result, btScalar near) const {
    int lowest = 0;
    for (int i = 1; i < hull_.m_faces.size(); ++i)
      if (face_normal(i).dot(normal_) < face_normal(lowest).dot(normal_)) lowest = i;
    Polygon corners = corners_of(lowest), scratch;
    for (int i = 0; i < 3; ++i) {
      const btVector3 side = t_[(i + 1) % 3] - t_[i];
      btVector3 out = side.cross(normal_);
      if (out.dot(t_[(i + 2) % 3] - t_[i]) > 0) out = -out;
      clip(corners, scratch, t_[i], out, folds_[i] == 0 ? 1 : 0);
    }
    for (int i = 0; i < corners.size(); ++i) {
      if (corners[i].w() > 0 && !is_corner(corners[i])) continue;
      const btScalar over = normal_.dot(corners[i] - t_[0]);
      if (over - margin_ < near) result.addContactPoint(normal_, corners[i] - normal_ * over, over - margin_);
    }
  }

  /// At the corners of the triangle within the hull's face.
  void meet_hull(btManifoldResult& result, btScalar near) const {
    Polygon corners, scratch;
    for (const btVector3& t : t_) corners.push_back(t);
    const Polygon face = corners_of(face_);
    btVector3 middle(0, 0, 0);
    for (int i = 0; i < face.size(); ++i) middle += face[i] / face.size();
    for (int i = 0; i < face.size(); ++i) {
      const btVector3& p = face[i];
      btVector3 out = (face[i + 1 < face.size() ? i + 1 : 0] - p).cross(axis_);
      if (out.dot(middle - p) > 0) out = -out;
      clip(corners, scratch, p, out, 0);
    }
    for (int i = 0; i < corners.size(); ++i) {
      const btScalar distance = axis_.dot(face[0] - corners[i]) - margin_;
      if (distance < near) result.addContactPoint(axis_, corners[i], distance);
    }
  }

  /// At the point of the triangle's side that is nearest to the hull's edge.
  void meet_edges(btManifoldResult& result) const {
    btVector3 low = X_ * hull_.m_vertices[0];
    for (int i = 1; i < hull_.m_vertices.size(); ++i) {
      const btVector3 p = X_ * hull_.m_vertices[i];
      if (axis_.dot(p) < axis_.dot(low)) low = p;
    }
    const btVector3 &t = t_[side_], side = t_[(side_ + 1) % 3] - t;
    const btVector3 across = edge_.cross(axis_);  // of the hull's edge
    const btScalar share = across.dot(low - t) / across.dot(side);
    result.addContactPoint(axis_, t + side * btMax(btScalar(0), btMin(btScalar(1), share)), best_);
  }

  const btConvexPolyhedron& hull_;
  const btTransform& X_;
  const btScalar margin_;
  const std::array<double, 3>& folds_;
  std::array<btVector3, 3> t_;
  btVector3 normal_, center_;
  bool is_flat_ = false, is_front_ = true;
  // The best axis.
  Kind kind_ = Kind::kTriangle;
  btVector3 axis_{0, 0, 0}, edge_{0, 0, 0};
  btScalar best_ = 0;
  int face_ = 0, side_ = 0;
};

class Algorithm final : public btCollisionAlgorithm {
 public:
  explicit Algorithm(const btCollisionAlgorithmConstructionInfo& info)
      : btCollisionAlgorithm(info), contacts_(info.m_manifold) {}

  void processCollision(const btCollisionObjectWrapper* hull, const btCollisionObjectWrapper* triangle,
                        const btDispatcherInfo&, btManifoldResult* result) override {
    result->setPersistentManifold(contacts_);
    const btCollisionShape& sheet = *triangle->getCollisionObject()->getCollisionShape();
    const auto& surface = *static_cast<const SurfaceShape*>(sheet.getUserPointer());
    const btVector3* p = static_cast<const btTriangleShape&>(*triangle->getCollisionShape()).m_vertices1;
    const btTransform& X = triangle->getWorldTransform();
    meet_triangle(static_cast<const btConvexHullShape&>(*hull->getCollisionShape()),
                  hull->getWorldTransform(), {X * p[0], X * p[1], X * p[2]}, surface.folds(triangle->m_index),
                  contacts_->getContactBreakingThreshold(), *result);
  }
  btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                 btManifoldResult*) override {
    return 1;
  }
  void getAllContactManifolds(btManifoldArray&) override {}  // that of the mesh owns them

 private:
  btPersistentManifold* contacts_;
};

}  // namespace

void meet_triangle(const btConvexHullShape& hull, const btTransform& X_hull,
                   const std::array<btVector3, 3>& corners, const std::array<double, 3>& folds, btScalar near,
                   btManifoldResult& result) {
  Pair(hull, X_hull, corners, folds).meet(result, near);
}

btCollisionAlgorithm* MeshContacts::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                             const btCollisionObjectWrapper*,
                                                             const btCollisionObjectWrapper*) {
  return new (info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(Algorithm))) Algorithm(info);
}

}  // namespace playhouse::arena
