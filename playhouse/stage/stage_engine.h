#pragma once

/// StageEngine: owns the world and the tables of the 2D engine and runs the tick (step.cc). Thread: the tick
/// thread.

#include "playhouse/stage/motion.h"
#include "playhouse/stage/sense_phase.h"
#include "playhouse/world/engine.h"

namespace playhouse::stage {

class StageEngine final : public world::Engine {
 public:
  StageEngine(const scene::SceneDesc& scene, std::uint64_t seed, unsigned workers);

  void step() override;
  world::World& world() override { return world_; }
  std::uint64_t rays() const override { return rays_; }

 private:
  /// Takes in the changes since the last tick.
  void ingest();
  /// Makes every table anew that follows from who there is; those of what stands still only if `fixed`.
  void populate(bool fixed);
  void replace(const world::Change& change);
  void decide();
  void index();
  void sense();
  void freeze();

  world::World world_;
  world::Workers workers_;
  std::uint64_t next_change_ = 0;  // of world_.changes
  Shapes shapes_;
  Trees trees_;
  Solids solids_;
  DiscIndex index_;  // solids that can move
  Walls walls_;
  Motion motion_;
  Senses senses_;
  std::uint64_t rays_ = 0;
};

}  // namespace playhouse::stage
