#pragma once

/// StageEngine: the phases of the tick (behaviour/phased_engine.h) that know about bodies in a plane, and
/// their tables. Thread: the tick thread.

#include "playhouse/behaviour/phased_engine.h"
#include "playhouse/stage/motion.h"
#include "playhouse/stage/sense_phase.h"

namespace playhouse::stage {

class StageEngine final : public behaviour::PhasedEngine {
 public:
  StageEngine(const scene::SceneDesc& scene, std::uint64_t seed, unsigned workers);

  std::uint64_t rays() const override { return rays_; }

 private:
  void ingest(std::span<const world::Change> changes) override;
  void move() override;
  void sense(std::uint64_t tick) override;
  void touching(world::ModelRow model, std::span<const std::uint8_t> wanted,
                std::vector<std::uint32_t>& out) const override;
  /// Makes every table anew that follows from who there is; those of what stands still only if `fixed`.
  void populate(bool fixed);
  bool moves_within_body(const world::Change& change) const;
  void replace(const world::Change& change);
  void index();
  Space space() const { return {solids_, index_, walls_}; }

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
