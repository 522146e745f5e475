#include "playhouse/arena/ground_contacts.h"

#include <new>

namespace playhouse::arena {
namespace {

class Algorithm final : public btCollisionAlgorithm {
 public:
  Algorithm(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObject& hull,
            const btCollisionObject& plane, bool plane_first)
      : btCollisionAlgorithm(info), plane_first_(plane_first) {
    if (m_dispatcher->needsCollision(&hull, &plane)) contacts_ = m_dispatcher->getNewManifold(&hull, &plane);
  }
  ~Algorithm() override {
    if (contacts_ != nullptr) m_dispatcher->releaseManifold(contacts_);
  }

  void processCollision(const btCollisionObjectWrapper* first, const btCollisionObjectWrapper* second,
                        const btDispatcherInfo&, btManifoldResult* result) override {
    if (contacts_ == nullptr) return;
    const btCollisionObjectWrapper &hull = plane_first_ ? *second : *first,
                                   &plane = plane_first_ ? *first : *second;
    result->setPersistentManifold(contacts_);
    const auto& shape = static_cast<const btConvexHullShape&>(*hull.getCollisionShape());
    const auto& ground = static_cast<const btStaticPlaneShape&>(*plane.getCollisionShape());
    const btTransform &X_WH = hull.getWorldTransform(), &X_WG = plane.getWorldTransform();
    const btVector3 normal = X_WG.getBasis() * ground.getPlaneNormal();
    const btScalar height = normal.dot(X_WG.getOrigin()) + ground.getPlaneConstant() + shape.getMargin();
    for (int i = 0; i < shape.getNumPoints(); ++i) {
      const btVector3 p = X_WH * shape.getScaledPoint(i);
      const btScalar distance = normal.dot(p) - height;
      if (distance < contacts_->getContactBreakingThreshold())
        result->addContactPoint(normal, p - normal * (distance + shape.getMargin()), distance);
    }
    if (contacts_->getNumContacts() > 0) result->refreshContactPoints();
  }
  btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                 btManifoldResult*) override {
    return 1;
  }
  void getAllContactManifolds(btManifoldArray& all) override {
    if (contacts_ != nullptr) all.push_back(contacts_);
  }

 private:
  const bool plane_first_;
  btPersistentManifold* contacts_ = nullptr;
};

}  // namespace

btCollisionAlgorithm* GroundContacts::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                               const btCollisionObjectWrapper* first,
                                                               const btCollisionObjectWrapper* second) {
  const btCollisionObject &hull = *(m_swapped ? second : first)->getCollisionObject(),
                          &plane = *(m_swapped ? first : second)->getCollisionObject();
  return new (info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(Algorithm)))
      Algorithm(info, hull, plane, m_swapped);
}

}  // namespace playhouse::arena
