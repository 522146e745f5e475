#pragma once

/// What Bullet's dispatcher asks of our own contact algorithms: manifolds of their own for a pair of a shape
/// of theirs and another one, in either order.
///
/// In: a pair of shapes whose boxes overlap.
/// Out: its contacts, in N manifolds.
/// Cost: N manifolds for each pair, and that of meet().

#include <array>
#include <cstddef>
#include <new>

#include "playhouse/arena/physics/bullet.h"

namespace playhouse::arena {

/// With N manifolds, for contacts of different normals.
template <std::size_t N>
class PairAlgorithm : public btCollisionAlgorithm {
 public:
  PairAlgorithm(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* first,
                const btCollisionObjectWrapper* second, bool own_second)
      : btCollisionAlgorithm(info), own_second_(own_second) {
    const btCollisionObject &own = *(own_second ? second : first)->getCollisionObject(),
                            &other = *(own_second ? first : second)->getCollisionObject();
    if (!m_dispatcher->needsCollision(&own, &other)) return;
    for (auto& contacts : contacts_) contacts = m_dispatcher->getNewManifold(&own, &other);
  }
  ~PairAlgorithm() override {
    for (btPersistentManifold* contacts : contacts_)
      if (contacts != nullptr) m_dispatcher->releaseManifold(contacts);
  }

  void processCollision(const btCollisionObjectWrapper* first, const btCollisionObjectWrapper* second,
                        const btDispatcherInfo&, btManifoldResult* result) final {
    if (contacts_[0] == nullptr) return;
    if (own_second_)
      meet(*second, *first, contacts_, *result);
    else
      meet(*first, *second, contacts_, *result);
  }
  btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                 btManifoldResult*) override {
    return 1;
  }
  void getAllContactManifolds(btManifoldArray& all) override {
    for (btPersistentManifold* contacts : contacts_)
      if (contacts != nullptr) all.push_back(contacts);
  }

 protected:
  using Manifolds = std::array<btPersistentManifold*, N>;
  /// Puts the contacts of a step into the manifolds.
  virtual void meet(const btCollisionObjectWrapper& own, const btCollisionObjectWrapper& other,
                    const Manifolds& contacts, btManifoldResult& result) const = 0;

 private:
  const bool own_second_;
  Manifolds contacts_{};
};

/// The body of CreateCollisionAlgorithm(), in Bullet's memory.
template <typename Algorithm>
btCollisionAlgorithm* make_pair_algorithm(const btCollisionAlgorithmConstructionInfo& info,
                                          const btCollisionObjectWrapper* first,
                                          const btCollisionObjectWrapper* second, bool own_second) {
  return new (info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(Algorithm)))
      Algorithm(info, first, second, own_second);
}

}  // namespace playhouse::arena
