#pragma once

/// FiducialSense: the phase that finds marked models (fiducial_return not 0) in the field of view of finders
/// that are subscribed and due.

#include <vector>

#include "playhouse/stage/space.h"
#include "playhouse/world/workers.h"

namespace playhouse::stage {

class FiducialSense {
 public:
  FiducialSense(const world::World& world, const Solids& solids);

  /// Measures for `tick`, the number that the state gets when it is frozen. Returns the rays cast.
  std::uint64_t sense(world::World& world, const Space& space, std::uint64_t tick, world::Workers& workers);

 private:
  void find(world::World& world, const Space& space, std::uint32_t finder) const;

  std::vector<std::uint64_t> period_;  // ticks between two looks (finders)
  std::vector<double> z_min_, z_max_;  // of the solids of a model's tree, from its top's z   [m] (models)
  std::vector<std::uint32_t> marked_, due_;  // models and finders of this tick
  DiscIndex targets_;                        // the marked models, as points
};

}  // namespace playhouse::stage
