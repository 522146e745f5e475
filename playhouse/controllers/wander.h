#pragma once

/// wander: drives ahead and turns away from what a scanner sees. Stage's constants; see docs/controllers.md.

#include "playhouse/base/rng.h"
#include "playhouse/controllers/batch.h"

namespace playhouse::controllers {

class Wander final : public Batch {
 public:
  /// Uses the first scanner of more than eight samples, or else the sensor with the most.
  Result<void> add(world::World& world, const Post& post) override;

  std::size_t size() const override { return robot_.size(); }
  void decide(world::World& world, std::size_t begin, std::size_t end) override;
  void hash(Hash& hash) const override;

 private:
  // Fixed, one row per robot.
  std::vector<world::PositionRow> robot_;
  std::vector<Stream> stream_;
  std::vector<world::RangerRow> ranger_;
  std::vector<std::uint32_t> first_beam_, beams_;

  // State.
  std::vector<std::uint64_t> seen_;      // tick of the last scan acted on
  std::vector<std::uint32_t> avoiding_;  // scans for which the turn is kept
  std::vector<double> turn_;             // rad/s
};

}  // namespace playhouse::controllers
