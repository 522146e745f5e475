#pragma once

/// RangerSense: the phase that fills the scans of rangers that are subscribed and due. Every beam
/// gets the exact distance to the nearest outline at its height (rays/measure.h).

#include <span>
#include <vector>

#include "playhouse/rays/measure.h"
#include "playhouse/rays/ranger_kinds.h"
#include "playhouse/senses/generated/senses.h"

namespace playhouse::senses {

class RangerSense final : public SensePhase {
 public:
  explicit RangerSense(unsigned workers);

  SensorTable table(world::World& world) const override;
  void populate(const world::World& world, const bodies::Space& space) override;
  std::uint64_t sense(world::World& world, const bodies::Space& space, std::span<const world::KindRow> due,
                      std::uint64_t tick, world::Workers& workers) override;

 private:
  std::size_t beams(world::RangerRow ranger) const { return kinds_.kinds[kinds_.of_ranger[ranger]].beams; }
  void measure_batch(world::World& world, const bodies::Space& space, std::span<const world::KindRow> rangers,
                     std::uint64_t tick, rays::Scratch& scratch) const;
  void measure(world::World& world, const bodies::Space& space, world::RangerRow ranger, std::uint64_t tick,
               rays::Scratch& scratch) const;
  void finish(world::World& world, world::RangerRow ranger, std::uint64_t tick, rays::Scratch& scratch) const;

  static void run_jitter(const bodies::Space& space, const rays::RangerView& view, const rays::Jitter& jitter,
                         double bearing, rays::Scratch& scratch);

  rays::RangerKinds kinds_;
  std::vector<float> returns_;            // return value of a beam that hit a solid (solids); of a miss first
  world::ByModel<std::uint8_t> is_wall_;  // 1: of a static tree
  std::size_t scratch_beams_ = 0;         // capacity of a rays::Scratch in beams
  std::vector<rays::Scratch> scratch_;    // one per worker
};

}  // namespace playhouse::senses
