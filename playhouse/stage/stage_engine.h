#pragma once

/// StageEngine: owns the world and the tables of the 2D engine and runs the tick (step.cc). Thread: the tick
/// thread.

#include "playhouse/stage/motion.h"
#include "playhouse/stage/sense_fiducial.h"
#include "playhouse/stage/sense_ranger.h"
#include "playhouse/world/engine.h"

namespace playhouse::stage {

class StageEngine final : public world::Engine {
 public:
  StageEngine(const scene::SceneDesc& scene, std::uint64_t seed, unsigned workers);

  void step() override;
  world::World& world() override { return world_; }
  std::uint64_t rays() const override { return rays_; }

 private:
  void ingest();
  void decide();
  void index();
  void sense();
  void freeze();

  world::World world_;
  world::Workers workers_;
  Trees trees_;
  Solids solids_;
  DiscIndex index_;  // moving solids
  Walls walls_;
  Motion motion_;
  RangerSense rangers_;
  FiducialSense fiducials_;
  std::uint64_t rays_ = 0;
};

}  // namespace playhouse::stage
