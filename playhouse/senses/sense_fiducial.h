#pragma once

/// FiducialSense: the phase that finds models with fiducial_return !=
/// 0 in the field of view of the finders that are subscribed and due.

#include <vector>

#include "playhouse/senses/generated/senses.h"

namespace playhouse::senses {

class FiducialSense final : public SensePhase {
 public:
  SensorTable table(world::World& world) const override;
  void populate(const world::World& world, const bodies::Space& space) override;
  std::uint64_t sense(world::World& world, const bodies::Space& space, std::span<const world::KindRow> due,
                      std::uint64_t tick, world::Workers& workers) override;

 private:
  void measure_heights(const bodies::Solids& solids);
  void find(world::World& world, const bodies::Space& space, world::FiducialRow finder) const;

  world::ByModel<double> z_min_,
      z_max_;                            // of trees, by their roots, in W  [m] (models, if there is a finder)
  std::vector<world::ModelRow> marked_;  // models visible to finders in this tick
  bodies::DiscIndex targets_;            // the marked models, as points
};

}  // namespace playhouse::senses
