#pragma once

/// PoseSense: what measures by the pose of its own body alone, and casts no rays.

#include "playhouse/stage/sense_phase.h"

namespace playhouse::stage {

class PoseSense : public SensePhase {
 public:
  void populate(const world::World&, const Space&) final {}
  std::uint64_t sense(world::World& world, const Space&, std::span<const std::uint32_t> due,
                      std::uint64_t tick, world::Workers& workers) final {
    workers.run(due.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) measure(world, due[i], tick);
    });
    return 0;
  }

 protected:
  /// Where the body of a model is: X_WB.
  static geom::SpatialPose body_pose(const world::World& world, world::ModelRow model) {
    return geom::compose({world.models.X_WM[model.index], world.models.tilt_WM[model.index]},
                         {world.desc(model).X_MB, geom::Tilt{}});
  }

 private:
  /// Row `row` of its table, which no other call writes. On any worker.
  virtual void measure(world::World& world, std::uint32_t row, std::uint64_t tick) const = 0;
};

}  // namespace playhouse::stage
