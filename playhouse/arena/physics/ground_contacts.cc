#include "playhouse/arena/physics/ground_contacts.h"

#include "playhouse/arena/physics/pair_algorithm.h"

namespace playhouse::arena {
namespace {

class GroundAlgorithm final : public PairAlgorithm<1> {
 public:
  using PairAlgorithm::PairAlgorithm;

 private:
  void meet(const btCollisionObjectWrapper& hull, const btCollisionObjectWrapper& plane,
            const Manifolds& manifolds, btManifoldResult& result) const override {
    btPersistentManifold& contacts = *manifolds[0];
    result.setPersistentManifold(&contacts);
    const auto& shape = static_cast<const btConvexHullShape&>(*hull.getCollisionShape());
    const auto& ground = static_cast<const btStaticPlaneShape&>(*plane.getCollisionShape());
    const btTransform &X_WH = hull.getWorldTransform(), &X_WG = plane.getWorldTransform();
    const btVector3 normal = X_WG.getBasis() * ground.getPlaneNormal();
    const btScalar height = normal.dot(X_WG.getOrigin()) + ground.getPlaneConstant() + shape.getMargin();
    for (int i = 0; i < shape.getNumPoints(); ++i) {
      const btVector3 p = X_WH * shape.getScaledPoint(i);
      const btScalar distance = normal.dot(p) - height;
      if (distance < contacts.getContactBreakingThreshold())
        result.addContactPoint(normal, p - normal * (distance + shape.getMargin()), distance);
    }
    if (contacts.getNumContacts() > 0) result.refreshContactPoints();
  }
};

}  // namespace

btCollisionAlgorithm* GroundContacts::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                               const btCollisionObjectWrapper* first,
                                                               const btCollisionObjectWrapper* second) {
  return make_pair_algorithm<GroundAlgorithm>(info, first, second, m_swapped);
}

}  // namespace playhouse::arena
