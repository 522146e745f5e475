#pragma once

/// expand_swarm and expand_pioneer: robots spread out, each towards the mean direction of free space around
/// it. Works with any ring of range sensors. Constants are Stage's; see docs/controllers.md.

#include <map>

#include "playhouse/controllers/batch.h"

namespace playhouse::controllers {

/// How a kind of robot spreads.
struct ExpandConfig {
  double cruise = 0;        // m/s, when the way is free
  double gain = 1;          // rad/s of turn per rad of bearing to free space
  double free_angle = 0.5;  // rad, drives only while free space is no further off than this
  float safe_distance = 0;  // m, wanted ahead; half of it on the flanks
  double ahead = 0;         // rad, sensors up to this bearing look ahead
  double flank = 0;         // rad, sensors beyond `ahead` up to this bearing look at the flanks
};

inline constexpr ExpandConfig kExpandSwarm{.cruise = 0.3, .safe_distance = 0.5f, .ahead = 0.6, .flank = 1.6};
inline constexpr ExpandConfig kExpandPioneer{
    .cruise = 0.2, .safe_distance = 0.75f, .ahead = 0.2, .flank = 1.0};

class Expand final : public Batch {
 public:
  explicit Expand(const ExpandConfig& config) : config_(config) {}

  /// Uses the ranger with the most sensors (the ring), the first of equals.
  Result<void> add(world::World& world, const Post& post) override;

  std::size_t size() const override { return robot_.size(); }
  void decide(world::World& world, std::size_t begin, std::size_t end) override;
  void hash(Hash& hash) const override;

 private:
  /// What follows from the directions of a ring's beams; shared by all robots with the same ring.
  struct Ring {
    std::vector<float> x, y;   // direction of each beam in the robot's frame
    std::vector<float> clear;  // m, each beam must be at least this long to drive on; 0: it doesn't matter
  };
  std::uint32_t ring_of(const std::vector<float>& bearings);

  ExpandConfig config_;
  std::vector<Ring> rings_;
  std::map<std::vector<float>, std::uint32_t> ring_by_bearings_;

  // Fixed, one row per robot.
  std::vector<world::PositionRow> robot_;
  std::vector<world::RangerRow> ranger_;
  std::vector<std::uint32_t> first_beam_, ring_;

  // State.
  std::vector<std::uint64_t> seen_;  // tick of the last scan acted on
};

}  // namespace playhouse::controllers
