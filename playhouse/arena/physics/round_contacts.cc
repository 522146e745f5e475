#include "playhouse/arena/physics/round_contacts.h"

#include <BulletCollision/CollisionShapes/btConvexPolyhedron.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "playhouse/arena/physics/cylinder_contacts.h"
#include "playhouse/arena/physics/pair_algorithm.h"

namespace playhouse::arena {
namespace {

constexpr double kSame = 1e-7;            // m between points that are one
constexpr double kNearer = 1e-9;          // m
constexpr double kAlike = 0.999;          // cosine of the angle between normals that count as one
constexpr double kNoLength = 1e-18;       // squared length of what has no direction
constexpr std::size_t kMostContacts = 4;  // contacts of a pair, as Bullet keeps
constexpr std::size_t kParts = 32;        // of an axis

/// An axis and the radius about it, in W or in the frame of what it meets.
struct RoundAxis {
  btVector3 low, high;
  btScalar radius;

  bool is_point() const { return low == high; }
  btVector3 at(btScalar share) const { return low + share * (high - low); }
  btScalar share_at(const btVector3& p) const {
    const btVector3 along = high - low;
    return is_point() ? 0 : btClamped(along.dot(p - low) / along.length2(), btScalar(0), btScalar(1));
  }
};

RoundAxis axis_of(const btCollisionShape& shape, const btTransform& X) {
  if (shape.getShapeType() == SPHERE_SHAPE_PROXYTYPE)
    return {X.getOrigin(), X.getOrigin(), static_cast<const btSphereShape&>(shape).getRadius()};
  const auto& capsule = static_cast<const btCapsuleShape&>(shape);
  const btVector3 half = X.getBasis().getColumn(2) * capsule.getHalfHeight();
  return {X.getOrigin() - half, X.getOrigin() + half, capsule.getRadius()};
}

/// Where something is nearest to a point of an axis.
struct Touch {
  btVector3 p;         // on it
  btVector3 normal;    // from it to the axis
  btScalar distance;   // of the axis, negative inside
  btScalar share = 0;  // along the axis
};

btVector3 nearest_on_segment(const btVector3& a, const btVector3& b, const btVector3& c) {
  return RoundAxis{a, b, 0}.at(RoundAxis{a, b, 0}.share_at(c));
}

/// The point of a convex polygon, with unit normal n, that is nearest to c.
template <typename Corner>
btVector3 nearest_on_polygon(int count, const Corner& corner, const btVector3& n, const btVector3& c) {
  btVector3 middle(0, 0, 0), nearest = c - n * n.dot(c - corner(0));
  for (int i = 0; i < count; ++i) middle += corner(i) / count;
  btScalar least = BT_LARGE_FLOAT;
  for (int i = 0; i < count; ++i) {
    const btVector3 &a = corner(i), &b = corner(i + 1 < count ? i + 1 : 0);
    btVector3 out = (b - a).cross(n);
    if (out.dot(middle - a) > 0) out = -out;
    if (out.dot(c - a) <= 0) continue;
    const btVector3 p = nearest_on_segment(a, b, c);
    if (p.distance2(c) >= least) continue;
    least = p.distance2(c);
    nearest = p;
  }
  return nearest;
}

/// Shares of an axis, between its ends, that are nearest to something. Of those in each part of the axis it
/// keeps the nearest, the lowest and the highest: there may be thousands above small triangles.
class Places {
 public:
  void add(btScalar share, btScalar distance2) {
    Part& part = parts_[std::min(static_cast<std::size_t>(share * kParts), kParts - 1)];
    part.low = std::min(part.low, share);
    part.high = std::max(part.high, share);
    if (distance2 > part.distance2 || (distance2 == part.distance2 && share > part.nearest)) return;
    part.distance2 = distance2;
    part.nearest = share;
  }
  std::vector<btScalar> shares() const {
    std::vector<btScalar> shares;
    for (const Part& part : parts_) {
      if (part.low > part.high) continue;
      shares.push_back(part.low);
      if (part.nearest > part.low) shares.push_back(part.nearest);
      if (part.high > part.nearest) shares.push_back(part.high);
    }
    return shares;
  }

 private:
  struct Part {
    btScalar low = 1, high = 0, nearest = 0, distance2 = BT_LARGE_FLOAT;  // low > high: no place
  };
  std::array<Part, kParts> parts_;
};

/// What a round solid may touch.
class Opposite {
 public:
  virtual ~Opposite() = default;
  /// Adds where it is nearest to a point of the axis, if that is nearer than `reach`. Share is left to do.
  virtual void meet(const btVector3& c, btScalar reach, std::vector<Touch>& touches) const = 0;
  /// Adds the shares of the axis, between its ends, that are nearest to an edge within `reach`.
  virtual void find_places(const RoundAxis&, btScalar, Places&) const {}

 protected:
  static void add_end(const RoundAxis& axis, const btVector3& end, Places& places) {
    const btScalar share = axis.share_at(end);
    if (share > 0 && share < 1) places.add(share, axis.at(share).distance2(end));
  }
  static void add_place(const RoundAxis& axis, const btVector3& a, const btVector3& b, btScalar reach,
                        Places& places) {
    const btVector3 u = axis.high - axis.low, v = b - a, w = axis.low - a;
    const btScalar uu = u.length2(), uv = u.dot(v), vv = v.length2(), across = uu * vv - uv * uv;
    if (across <= 1e-9 * uu * vv) return;  // parallel: the corners and the ends are the places
    const btScalar on_edge = btClamped((uu * v.dot(w) - uv * u.dot(w)) / across, btScalar(0), btScalar(1));
    const btVector3 p = a + on_edge * v;
    const btScalar share = axis.share_at(p), distance2 = axis.at(share).distance2(p);
    if (share > 0 && share < 1 && distance2 < reach * reach) places.add(share, distance2);
  }
};

class OppositePlane final : public Opposite {
 public:
  OppositePlane(const btStaticPlaneShape& plane, const btTransform& X)
      : normal_(X.getBasis() * plane.getPlaneNormal()),
        height_(normal_.dot(X.getOrigin()) + plane.getPlaneConstant()) {}
  void meet(const btVector3& c, btScalar, std::vector<Touch>& touches) const override {
    const btScalar over = normal_.dot(c) - height_;
    touches.push_back({c - normal_ * over, normal_, over});
  }

 private:
  btVector3 normal_;
  btScalar height_;
};

class OppositeRound final : public Opposite {
 public:
  explicit OppositeRound(const RoundAxis& axis) : axis_(axis) {}
  void meet(const btVector3& c, btScalar, std::vector<Touch>& touches) const override {
    const btVector3 p = axis_.at(axis_.share_at(c)), arm = c - p;
    const btScalar length = arm.length();
    const btVector3 normal = length > 0 ? arm / length : btVector3(0, 0, 1);
    touches.push_back({p + normal * axis_.radius, normal, length - axis_.radius});
  }
  void find_places(const RoundAxis& axis, btScalar reach, Places& places) const override {
    for (const btVector3& end : {axis_.low, axis_.high}) add_end(axis, end, places);
    add_place(axis, axis_.low, axis_.high, reach + axis_.radius, places);
  }

 private:
  RoundAxis axis_;
};

/// A cylinder.
class OppositeCylinder final : public Opposite {
 public:
  OppositeCylinder(const CylinderShape& cylinder, const btTransform& X)
      : middle_(X * cylinder.middle()),
        axis_(X.getBasis() * cylinder.axis()),
        radius_(cylinder.radius()),
        half_(cylinder.half()) {}
  void meet(const btVector3& c, btScalar, std::vector<Touch>& touches) const override {
    const btScalar along = axis_.dot(c - middle_), over = btFabs(along) - half_;
    const btVector3 end = along < 0 ? -axis_ : axis_, arm = c - middle_ - axis_ * along;
    const btScalar distance = arm.length(), beside = distance - radius_;
    const btVector3 out = distance > kSame ? arm / distance : end;
    if (over > 0 && beside > 0) {  // at the rim
      const btVector3 p = middle_ + end * half_ + out * radius_;
      touches.push_back({p, (c - p).normalized(), c.distance(p)});
    } else if (over > beside) {
      touches.push_back({c - end * over, end, over});
    } else {
      touches.push_back({c - out * beside, out, beside});
    }
  }
  void find_places(const RoundAxis& axis, btScalar reach, Places& places) const override {
    const btVector3 arm = axis_ * half_;
    for (const btVector3& end : {middle_ - arm, middle_ + arm}) add_end(axis, end, places);
    add_place(axis, middle_ - arm, middle_ + arm, reach + radius_, places);
  }

 private:
  btVector3 middle_, axis_;
  btScalar radius_, half_;
};

/// A convex polyhedron, in its own frame.
class OppositeHull final : public Opposite {
 public:
  explicit OppositeHull(const btConvexHullShape& hull)
      : hull_(*hull.getConvexPolyhedron()), margin_(hull.getMargin()) {}

  void meet(const btVector3& c, btScalar reach, std::vector<Touch>& touches) const override {
    btScalar highest = -BT_LARGE_FLOAT;
    int above = 0;  // the face that c is farthest above
    for (int i = 0; i < hull_.m_faces.size(); ++i)
      if (const btScalar over = over_face(i, c); over > highest) highest = over, above = i;
    if (highest > reach + margin_) return;
    if (highest <= 0) {
      const btVector3 n = normal(above);
      touches.push_back({c + n * (margin_ - highest), n, highest - margin_});
      return;
    }
    btVector3 nearest = c;
    btScalar least = BT_LARGE_FLOAT;
    for (int i = 0; i < hull_.m_faces.size(); ++i) {
      if (over_face(i, c) <= 0) continue;
      const auto corner = [&](int k) -> const btVector3& { return corner_of(i, k); };
      const btVector3 p = nearest_on_polygon(hull_.m_faces[i].m_indices.size(), corner, normal(i), c);
      if (p.distance2(c) < least) least = p.distance2(c), nearest = p;
    }
    const btScalar length = btSqrt(least);
    const btVector3 n = length > kSame ? (c - nearest) / length : normal(above);
    touches.push_back({nearest + n * margin_, n, length - margin_});
  }
  void find_places(const RoundAxis& axis, btScalar reach, Places& places) const override {
    for (int i = 0; i < hull_.m_faces.size(); ++i) {
      const auto& rows = hull_.m_faces[i].m_indices;
      for (int k = 0; k < rows.size(); ++k) {
        const int next = k + 1 < rows.size() ? k + 1 : 0;
        if (rows[k] < rows[next])
          add_place(axis, corner_of(i, k), corner_of(i, next), reach + margin_, places);
      }
    }
  }

 private:
  btVector3 normal(int face) const {
    const btScalar* plane = hull_.m_faces[face].m_plane;
    return {plane[0], plane[1], plane[2]};
  }
  const btVector3& corner_of(int face, int i) const {
    return hull_.m_vertices[hull_.m_faces[face].m_indices[i]];
  }
  btScalar over_face(int face, const btVector3& c) const { return normal(face).dot(c - corner_of(face, 0)); }

  const btConvexPolyhedron& hull_;
  const btScalar margin_;
};

/// The triangles of a mesh near an axis, in the frame of the mesh.
class OppositeSheet final : public Opposite, btTriangleCallback {
 public:
  OppositeSheet(const btConcaveShape& sheet, const RoundAxis& axis, btScalar near) {
    const btScalar reach = axis.radius + near;
    btVector3 low = axis.low, high = axis.low;
    low.setMin(axis.high);
    high.setMax(axis.high);
    const btVector3 all(reach, reach, reach);
    sheet.processAllTriangles(this, low - all, high + all);
  }
  void processTriangle(btVector3* p, int, int) override {
    Triangle triangle{{p[0], p[1], p[2]}, (p[1] - p[0]).cross(p[2] - p[0])};
    if (triangle.normal.length2() <= kNoLength) return;  // its sides are those of others
    triangle.normal.normalize();
    triangle.low = triangle.high = p[0];
    for (int i = 1; i < 3; ++i) {
      triangle.low.setMin(p[i]);
      triangle.high.setMax(p[i]);
    }
    triangles_.push_back(triangle);
  }

  /// Where no other triangle at the same point is nearer.
  void meet(const btVector3& c, btScalar reach, std::vector<Touch>& touches) const override {
    struct Near {
      const Triangle* triangle;
      btVector3 p;
      btScalar distance;
    };
    std::vector<Near> near;
    for (const Triangle& triangle : triangles_) {
      if (!triangle.has_near(c, reach)) continue;
      const btVector3 p = triangle.nearest(c);
      if (p.distance(c) < reach) near.push_back({&triangle, p, p.distance(c)});
    }
    std::ranges::stable_sort(near, {}, &Near::distance);
    const std::size_t first = touches.size();
    for (std::size_t row = 0; row < near.size(); ++row) {
      const Near& at = near[row];
      bool is_covered = false;
      for (std::size_t i = row; i > 0 && !is_covered; --i) {  // a neighbour is hardly nearer
        const Near& other = near[i - 1];
        is_covered = other.distance < at.distance - kNearer && other.triangle->has_near(at.p, kSame) &&
                     other.triangle->nearest(at.p).distance(at.p) < kSame;
      }
      const bool is_known = std::any_of(touches.begin() + static_cast<std::ptrdiff_t>(first), touches.end(),
                                        [&](const Touch& known) { return known.p.distance(at.p) < kSame; });
      if (is_covered || is_known) continue;
      const btVector3 up = at.distance > kSame ? (c - at.p) / at.distance : at.triangle->normal;
      touches.push_back({at.p, up, at.distance});
    }
  }
  void find_places(const RoundAxis& axis, btScalar reach, Places& places) const override {
    for (const Triangle& triangle : triangles_)
      for (int i = 0; i < 3; ++i)
        add_place(axis, triangle.corner[i], triangle.corner[(i + 1) % 3], reach, places);
  }

 private:
  struct Triangle {
    std::array<btVector3, 3> corner;
    btVector3 normal;
    btVector3 low{}, high{};  // its bounding box
    /// False only if the triangle is farther than `reach` from c.
    bool has_near(const btVector3& c, btScalar reach) const {
      for (int i = 0; i < 3; ++i)
        if (c[i] < low[i] - reach || c[i] > high[i] + reach) return false;
      return true;
    }
    btVector3 nearest(const btVector3& c) const {
      return nearest_on_polygon(
          3, [this](int i) -> const btVector3& { return corner[i]; }, normal, c);
    }
  };
  std::vector<Triangle> triangles_;
};

/// All touches of an axis, the deepest first, those between others of the same normal left out.
std::vector<Touch> touches_of(const RoundAxis& axis, const Opposite& opposite, btScalar near) {
  const btScalar reach = axis.radius + near;
  std::vector<btScalar> shares{0};
  if (!axis.is_point()) {
    Places places;
    opposite.find_places(axis, reach, places);
    shares = places.shares();
    shares.insert(shares.begin(), {0, 1});
  }
  std::vector<Touch> all, chosen;
  for (const btScalar share : shares) {
    std::size_t row = all.size();
    opposite.meet(axis.at(share), reach, all);
    for (; row < all.size(); ++row) all[row].share = share;
  }
  std::erase_if(all, [reach](const Touch& touch) { return touch.distance >= reach; });
  std::ranges::stable_sort(all, {}, &Touch::distance);
  for (const Touch& touch : all) {
    if (chosen.size() == kMostContacts) break;
    bool has_lower = false, has_higher = false, is_known = false;
    for (const Touch& other : all) {
      if (has_lower && has_higher) break;
      if (touch.normal.dot(other.normal) < kAlike) continue;
      has_lower = has_lower || other.share < touch.share;
      has_higher = has_higher || other.share > touch.share;
    }
    for (const Touch& other : chosen) is_known = is_known || touch.p.distance(other.p) < kSame;
    if (!is_known && !(has_lower && has_higher)) chosen.push_back(touch);
  }
  return chosen;
}

class RoundAlgorithm final : public PairAlgorithm<1> {
 public:
  using PairAlgorithm::PairAlgorithm;

 private:
  void meet(const btCollisionObjectWrapper& round, const btCollisionObjectWrapper& other,
            const Manifolds& manifolds, btManifoldResult& result) const override {
    btPersistentManifold& contacts = *manifolds[0];
    result.setPersistentManifold(&contacts);
    contacts.clearManifold();
    const RoundAxis axis = axis_of(*round.getCollisionShape(), round.getWorldTransform());
    const btTransform& X = other.getWorldTransform();
    const btScalar near = contacts.getContactBreakingThreshold();
    switch (const btCollisionShape& shape = *other.getCollisionShape(); shape.getShapeType()) {
      case STATIC_PLANE_PROXYTYPE:
        return add(result, axis, OppositePlane(static_cast<const btStaticPlaneShape&>(shape), X), near,
                   btTransform::getIdentity());
      case CONVEX_HULL_SHAPE_PROXYTYPE:
        return add(result, within(X, axis), OppositeHull(static_cast<const btConvexHullShape&>(shape)), near,
                   X);
      case CUSTOM_POLYHEDRAL_SHAPE_TYPE:
        return add(result, axis, OppositeCylinder(static_cast<const CylinderShape&>(shape), X), near,
                   btTransform::getIdentity());
      case TRIANGLE_MESH_SHAPE_PROXYTYPE: {
        const RoundAxis in_mesh = within(X, axis);
        return add(result, in_mesh, OppositeSheet(static_cast<const btConcaveShape&>(shape), in_mesh, near),
                   near, X);
      }
      default:
        return add(result, axis, OppositeRound(axis_of(shape, X)), near, btTransform::getIdentity());
    }
  }
  static RoundAxis within(const btTransform& X, const RoundAxis& axis) {
    const btTransform inverse = X.inverse();
    return {inverse * axis.low, axis.is_point() ? inverse * axis.low : inverse * axis.high, axis.radius};
  }
  /// Adds the contacts, of which `axis` and `opposite` are in the frame of X.
  static void add(btManifoldResult& result, const RoundAxis& axis, const Opposite& opposite, btScalar near,
                  const btTransform& X) {
    for (const Touch& touch : touches_of(axis, opposite, near))
      result.addContactPoint(X.getBasis() * touch.normal, X * touch.p, touch.distance - axis.radius);
  }
};

}  // namespace

btCollisionAlgorithm* RoundContacts::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                              const btCollisionObjectWrapper* first,
                                                              const btCollisionObjectWrapper* second) {
  return make_pair_algorithm<RoundAlgorithm>(info, first, second, m_swapped);
}

}  // namespace playhouse::arena
