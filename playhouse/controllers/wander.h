#pragma once

/// wander: drives ahead and turns away from what a scanner sees. Stage's constants; see docs/controllers.md.

#include "playhouse/base/rng.h"
#include "playhouse/controllers/batch.h"

namespace playhouse::controllers {

class Wander final : public BatchOf<Wander> {
 public:
  Wander() : BatchOf("wander") {}

  void decide(world::World& world, std::size_t begin, std::size_t end) override;

 private:
  friend BatchOf<Wander>;
  static auto memory(auto& self) { return std::tie(self.seen_, self.avoiding_, self.turn_); }
  /// Uses the first scanner of more than eight samples, or else the sensor with the most.
  Result<void> join(world::World& world, const Post& post) override;
  void leave_rest(std::size_t i) { erase_at(i, stream_, robot_, ranger_, first_beam_, beams_); }
  void resolve(const world::World& world, std::size_t i) override;
  void find_rows(const world::World& world, world::ModelRow model, std::size_t i);

  std::vector<Stream> stream_;

  // Rows of a robot and of the sensor it steers by.
  std::vector<world::PositionRow> robot_;
  std::vector<world::RangerRow> ranger_;
  std::vector<std::uint32_t> first_beam_, beams_;

  // Memory.
  std::vector<std::uint64_t> seen_;      // tick of the last scan acted on
  std::vector<std::uint32_t> avoiding_;  // scans for which the turn is kept
  std::vector<double> turn_;             // rad/s
};

}  // namespace playhouse::controllers
