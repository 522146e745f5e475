#pragma once

/// Steering: columns of robots with reactive obstacle avoidance by a scanner, as in
/// `wander`: ahead while it is free, otherwise a turn away from the nearer side, kept for
/// several scans. Constants of Stage; see docs/controllers.md. Thread: as world::Decider.

#include <span>
#include <vector>

#include "playhouse/base/rng.h"
#include "playhouse/controllers/batch.h"
#include "playhouse/controllers/free_way.h"

namespace playhouse::controllers {

class Steering {
 public:
  /// Appends a robot to all columns, with its first scanner of more than eight
  /// samples, otherwise the sensor with the most. Fails without a sensor or a drive.
  Result<void> join(world::World& world, const Post& post);
  void resolve(const world::World& world, world::ModelRow model, std::size_t i);
  /// Memory columns; see BatchOf.
  static auto memory(auto& self) { return std::tie(self.seen_, self.avoiding_, self.turn_); }
  /// Removes robot i from the other columns.
  void leave_rest(std::size_t i) { erase_at(i, stream_, robot_, ranger_, first_beam_, beams_, fan_); }

  world::PositionRow robot(std::size_t i) const { return robot_[i]; }
  const Stream& stream(std::size_t i) const { return stream_[i]; }
  /// Ranges of the latest scan, from right to left. [m]
  std::span<const float> beams(const world::World& world, std::size_t i) const {
    return std::span(world.sensors.ranges.from(first_beam_[i]), beams_[i]);
  }
  /// Bearings of the beams.
  const Fan& fan(std::size_t i) const { return fan_[i]; }
  /// True once per scan of robot i.
  bool is_new_scan(const world::World& world, std::size_t i);
  /// Drives ahead, or turns away from obstacles.
  void steer(world::World& world, std::size_t i);

 private:
  std::vector<Stream> stream_;

  // Rows of a robot and of its sensor.
  std::vector<world::PositionRow> robot_;
  std::vector<world::RangerRow> ranger_;
  std::vector<world::BeamRow> first_beam_;
  std::vector<std::uint32_t> beams_;
  std::vector<Fan> fan_;

  // Memory.
  std::vector<std::uint64_t> seen_;      // tick of the last scan acted on
  std::vector<std::uint32_t> avoiding_;  // remaining scans of the turn
  std::vector<double> turn_;             // rad/s
};

}  // namespace playhouse::controllers
