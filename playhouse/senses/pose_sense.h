#pragma once

/// PoseSense: base of the sensors that measure only the pose of their own body and cast no rays.

#include "playhouse/senses/body_motion.h"
#include "playhouse/senses/sense_phase.h"

namespace playhouse::senses {

class PoseSense : public SensePhase {
 public:
  void populate(const world::World&, const bodies::Space&) override {}
  std::uint64_t sense(world::World& world, const bodies::Space&, std::span<const world::KindRow> due,
                      std::uint64_t tick, world::Workers& workers) final {
    begin_tick(world);
    workers.run(due.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) measure(world, due[i], tick);
    });
    return 0;
  }

 private:
  /// Prepares what all measurements of a tick share.
  virtual void begin_tick(const world::World& world) { static_cast<void>(world); }
  /// Fills row `row` of its table; calls for different rows run in parallel.
  virtual void measure(world::World& world, world::KindRow row, std::uint64_t tick) const = 0;
};

}  // namespace playhouse::senses
