#include "playhouse/arena/physics/swept_world.h"

#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>

#include <algorithm>

#include "playhouse/arena/physics/moving.h"

namespace playhouse::arena {
namespace {

constexpr double kFast = 2;     // times the inset of its cores: a body that moves by more in a step is swept
constexpr double kNear = 1e-4;  // m: solids at this distance touch
constexpr int kAdvances = 32;   // of a core towards a solid, at most

/// The way of a core, relative to what it may meet.
class Sweep {
 public:
  Sweep(const btConvexShape& core, const btTransform& X, const btVector3& way)
      : core_(core), X_(X), way_(way) {}

  /// Share of the way that is free.
  double share() const { return share_; }

  void meet(const btCollisionShape& shape, const btTransform& X) {
    if (shape.isCompound())
      meet_parts(static_cast<const btCompoundShape&>(shape), X);
    else if (shape.isConcave())
      meet_triangles(static_cast<const btConcaveShape&>(shape), X);
    else
      meet_solid(static_cast<const btConvexShape&>(shape), X);
  }

 private:
  /// Bounds of the way in the frame of X.
  void bounds(const btTransform& X, btVector3& low, btVector3& high) const {
    const btTransform begin = X.inverse() * X_;
    core_.getAabb(begin, low, high);
    const btVector3 way = way_ * X.getBasis();
    btVector3 low_end = low + way, high_end = high + way;
    low.setMin(low_end);
    high.setMax(high_end);
  }

  void meet_parts(const btCompoundShape& parts, const btTransform& X) {
    struct Each final : btDbvt::ICollide {
      Sweep& sweep;
      const btCompoundShape& parts;
      const btTransform& X;
      Each(Sweep& sweep, const btCompoundShape& parts, const btTransform& X)
          : sweep(sweep), parts(parts), X(X) {}
      void Process(const btDbvtNode* leaf) override {
        const int i = leaf->dataAsInt;
        sweep.meet(*parts.getChildShape(i), X * parts.getChildTransform(i));
      }
    } each{*this, parts, X};
    btVector3 low, high;
    bounds(X, low, high);
    const btDbvt& tree = *parts.getDynamicAabbTree();
    tree.collideTV(tree.m_root, btDbvtVolume::FromMM(low, high), each);
  }

  void meet_triangles(const btConcaveShape& sheet, const btTransform& X) {
    struct Each final : btTriangleCallback {
      Sweep& sweep;
      const btTransform& X;
      Each(Sweep& sweep, const btTransform& X) : sweep(sweep), X(X) {}
      void processTriangle(btVector3* p, int, int) override {
        btTriangleShape triangle(p[0], p[1], p[2]);
        triangle.setMargin(0);
        sweep.meet_solid(triangle, X);
      }
    } each{*this, X};
    btVector3 low, high;
    bounds(X, low, high);
    sheet.processAllTriangles(&each, low, high);
  }

  /// Conservative advancement: to the plane between the nearest points, again and again.
  void meet_solid(const btConvexShape& solid, const btTransform& X) {
    btVoronoiSimplexSolver simplex;
    btGjkPairDetector gjk(&core_, &solid, &simplex, nullptr);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = X_;
    input.m_transformB = X;
    double share = 0;
    for (int i = 0; i < kAdvances; ++i) {
      input.m_transformA.setOrigin(X_.getOrigin() + share * way_);
      btPointCollector nearest;
      gjk.getClosestPoints(input, nearest, nullptr);
      if (!nearest.m_hasResult) break;
      const double closing = -way_.dot(nearest.m_normalOnBInWorld);
      if (nearest.m_distance < kNear) {
        // A core that overlaps at the start has contacts.
        if (share > 0 && closing > 0) share_ = std::min(share_, share);
        return;
      }
      if (closing <= 0) return;
      share += nearest.m_distance / closing;
      if (share >= share_) return;
    }
    if (share > 0) share_ = std::min(share_, share);
  }

  const btConvexShape& core_;
  const btTransform& X_;
  const btVector3 way_;
  double share_ = 1;
};

/// Share of the way of a body until a corner of it is at the ground, unless it comes to lie `deep` at most.
double share_above(const Moving& moving, const btTransform& from, const btTransform& to, double deep) {
  double share = 1;
  for (const Hull& hull : moving.desc.hulls)
    for (const Vec3& p : hull) {
      const btVector3 p_C = bullet(p - moving.desc.center);
      const double now = (from * p_C).z(), then = (to * p_C).z();
      if (now > 0 && then < -deep) share = std::min(share, now / (now - then));
    }
  return share;
}

btVector3 way_of(const btCollisionObject& object, double dt) {
  const btRigidBody& body = *btRigidBody::upcast(&object);
  if (body.isStaticOrKinematicObject() || !body.isActive()) return {0, 0, 0};
  return dt * body.getLinearVelocity();
}

/// What may be in the way of a body.
class Neighbours final : public btBroadphaseAabbCallback {
 public:
  explicit Neighbours(const btBroadphaseProxy& body) : body_(body) {}
  bool process(const btBroadphaseProxy* other) override {
    const bool meet = (other->m_collisionFilterGroup & body_.m_collisionFilterMask) != 0 &&
                      (body_.m_collisionFilterGroup & other->m_collisionFilterMask) != 0;
    if (meet && other != &body_)
      found.push_back(static_cast<const btCollisionObject*>(other->m_clientObject));
    return true;
  }
  btAlignedObjectArray<const btCollisionObject*> found;

 private:
  const btBroadphaseProxy& body_;
};

}  // namespace

/// Share of its way in a step that a body can go.
double SweptWorld::free_share(const Moving& moving, const btRigidBody& body, double dt) {
  const btTransform& X = body.getWorldTransform();
  const btVector3 way = way_of(body, dt);
  btVector3 low, high;
  body.getAabb(low, high);
  btVector3 low_end = low + way, high_end = high + way;
  low.setMin(low_end);
  high.setMax(high_end);
  Neighbours neighbours(*body.getBroadphaseProxy());
  getBroadphase()->aabbTest(low, high, neighbours);
  double share = 1;
  for (int i = 0; i < neighbours.found.size(); ++i) {
    const btCollisionObject& other = *neighbours.found[i];
    if (other.getCollisionShape()->getShapeType() == STATIC_PLANE_PROXYTYPE) {
      btTransform then;
      btTransformUtil::integrateTransform(X, body.getLinearVelocity(), body.getAngularVelocity(), dt, then);
      share = std::min(share, share_above(moving, X, then, moving.cores.inset()));
      continue;
    }
    for (const auto& core : moving.cores.hulls()) {
      Sweep sweep(*core, X, way - way_of(other, dt));
      sweep.meet(*other.getCollisionShape(), other.getWorldTransform());
      share = std::min(share, sweep.share());
    }
  }
  return share;
}

void SweptWorld::integrateTransforms(btScalar dt) {
  stops_.resize(0);
  for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
    btRigidBody& body = *m_nonStaticRigidBodies[i];
    if (body.isKinematicObject() || !body.isActive()) continue;
    const auto& moving = *static_cast<const Moving*>(body.getUserPointer());
    const double slow = kFast * moving.cores.inset();
    if (way_of(body, dt).length2() <= slow * slow) continue;
    const double share = free_share(moving, body, dt);
    if (share >= 1) continue;
    btTransform X;
    body.predictIntegratedTransform(share * dt, X);
    stops_.push_back({&body, X, share});
  }
  btDiscreteDynamicsWorld::integrateTransforms(dt);
  for (int i = 0; i < stops_.size(); ++i) {
    const Stop& stop = stops_[i];
    stop.body->proceedToTransform(stop.X);
    // It has fallen for a share of the step only.
    stop.body->setLinearVelocity(stop.body->getLinearVelocity() -
                                 (1 - stop.share) * dt * stop.body->getGravity());
  }
}

}  // namespace playhouse::arena
