#include "playhouse/arena/physics/stacks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace playhouse::arena {
namespace {

constexpr double kHigh = 7;     // bodies
constexpr double kHeavy = 100;  // times the mass of what bears it
constexpr double kMost = 16;    // factor
constexpr double kLevel = 0.5;  // vertical part of a normal of contacts that bear

/// A contact of two movable bodies, by which the lower one bears the upper one.
struct Bearing {
  std::size_t lower, upper;  // of Stacks::bodies
  double z_lower, z_upper;   // m, of their centers
};

bool is_level(const btPersistentManifold& contact) {
  for (int i = 0; i < contact.getNumContacts(); ++i)
    if (std::fabs(contact.getContactPoint(i).m_normalWorldOnB.z()) > kLevel) return true;
  return false;
}

struct Stacked {
  double mass;         // kg
  double height = 1;   // bodies on top of each other, up to this one
  double bearers = 0;  // bodies below
  double load = 0;     // kg, of all above
};

class Stacks {
 public:
  Stacks(btPersistentManifold* const* contacts, int count) {
    for (int i = 0; i < count; ++i) {
      const btRigidBody *a = btRigidBody::upcast(contacts[i]->getBody0()),
                        *b = btRigidBody::upcast(contacts[i]->getBody1());
      if (a->getInvMass() == 0 || b->getInvMass() == 0 || !is_level(*contacts[i])) continue;
      if (a->getCenterOfMassPosition().z() > b->getCenterOfMassPosition().z()) std::swap(a, b);
      bearings_.push_back(
          {row_of(*a), row_of(*b), a->getCenterOfMassPosition().z(), b->getCenterOfMassPosition().z()});
    }
  }

  bool empty() const { return bearings_.empty(); }

  /// The largest number of bodies on top of each other.
  double height() {
    std::ranges::stable_sort(bearings_, {}, &Bearing::z_lower);
    double highest = 1;
    for (const Bearing& bearing : bearings_) {
      double& height = bodies_[bearing.upper].height;
      height = std::max(height, bodies_[bearing.lower].height + 1);
      highest = std::max(highest, height);
    }
    return highest;
  }

  /// The largest load of a body, as a multiple of its mass. Who has several bearers loads each with its
  /// share.
  double load() {
    for (const Bearing& bearing : bearings_) ++bodies_[bearing.upper].bearers;
    std::ranges::stable_sort(bearings_, std::greater(), &Bearing::z_upper);
    double largest = 0;
    for (const Bearing& bearing : bearings_) {
      const Stacked& upper = bodies_[bearing.upper];
      Stacked& lower = bodies_[bearing.lower];
      lower.load += (upper.mass + upper.load) / upper.bearers;
      largest = std::max(largest, lower.load / lower.mass);
    }
    return largest;
  }

 private:
  std::size_t row_of(const btRigidBody& body) {
    const auto [at, is_new] = row_.try_emplace(&body, bodies_.size());
    if (is_new) bodies_.push_back({1 / body.getInvMass()});
    return at->second;
  }

  std::map<const btRigidBody*, std::size_t> row_;  // looked up, never in its order
  std::vector<Stacked> bodies_;
  std::vector<Bearing> bearings_;
};

}  // namespace

double more_iterations(btPersistentManifold* const* contacts, int count) {
  Stacks stacks(contacts, count);
  if (stacks.empty()) return 1;
  const double height = stacks.height() / kHigh;
  return std::clamp(std::max(height * height, stacks.load() / kHeavy), 1.0, kMost);
}

}  // namespace playhouse::arena
