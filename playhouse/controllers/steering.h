#pragma once

/// Steering: the columns of robots that drive by a scanner, and how `wander` does it: ahead while the way is
/// free, else a turn away from the nearer side, which is kept for a while. Stage's constants; see
/// docs/controllers.md. Thread: as world::Decider.

#include <span>
#include <vector>

#include "playhouse/base/rng.h"
#include "playhouse/controllers/batch.h"
#include "playhouse/controllers/free_way.h"

namespace playhouse::controllers {

class Steering {
 public:
  /// One more robot, at the end of every column, with the first scanner of more than eight samples, or else
  /// the sensor with the most. Fails where there is none, or no drive.
  Result<void> join(world::World& world, const Post& post);
  void resolve(const world::World& world, world::ModelRow model, std::size_t i);
  /// What robots remember; see BatchOf.
  static auto memory(auto& self) { return std::tie(self.seen_, self.avoiding_, self.turn_); }
  /// Erases the other columns of robot i.
  void leave_rest(std::size_t i) { erase_at(i, stream_, robot_, ranger_, first_beam_, beams_, fan_); }

  world::PositionRow robot(std::size_t i) const { return robot_[i]; }
  const Stream& stream(std::size_t i) const { return stream_[i]; }
  /// Beams of the newest scan, from right to left. [m]
  std::span<const float> beams(const world::World& world, std::size_t i) const {
    return std::span(world.sensors.ranges).subspan(first_beam_[i], beams_[i]);
  }
  /// Their bearings.
  const Fan& fan(std::size_t i) const { return fan_[i]; }
  /// Whether robot i has a scan that it was not told of yet.
  bool is_new_scan(const world::World& world, std::size_t i);
  /// Drives ahead, or turns away from what is near.
  void steer(world::World& world, std::size_t i);

 private:
  std::vector<Stream> stream_;

  // Rows of a robot and of the sensor it steers by.
  std::vector<world::PositionRow> robot_;
  std::vector<world::RangerRow> ranger_;
  std::vector<std::uint32_t> first_beam_, beams_;
  std::vector<Fan> fan_;

  // Memory.
  std::vector<std::uint64_t> seen_;      // tick of the last scan acted on
  std::vector<std::uint32_t> avoiding_;  // scans for which the turn is kept
  std::vector<double> turn_;             // rad/s
};

}  // namespace playhouse::controllers
