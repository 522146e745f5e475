#pragma once

/// StageEngine: planar motion with collision by refusal (motion.h). Thread: the tick thread.
///
/// In: the state before the phase `move`.
/// Out: the state after it (motion.h).
/// Cost: that of Motion::move().

#include "playhouse/senses/body_engine.h"
#include "playhouse/stage/motion.h"

namespace playhouse::stage {

class StageEngine final : public senses::BodyEngine {
 public:
  StageEngine(const scene::SceneDesc& scene, std::uint64_t seed, unsigned workers);

 private:
  void move() override;
  void populated(bool fixed) override;
  void replaced(bodies::TreeRow tree) override;

  Motion motion_;
};

}  // namespace playhouse::stage
