#pragma once

/// expand_swarm and expand_pioneer: robots spread out, each towards the mean direction of free space around
/// it. pioneer_flocking: they also turn as their neighbours are turned. Works with any ring of range sensors.
/// Constants are Stage's; see docs/controllers.md.

#include <map>
#include <span>

#include "playhouse/base/rng.h"
#include "playhouse/controllers/batch.h"

namespace playhouse::controllers {

/// How far beams must reach for the robot to drive: less to the sides than ahead.
struct Clearance {
  double up_to;       // rad, for beams up to this bearing on either side, from the clearance before it on
  float longer_than;  // m
};

/// How a kind of robot spreads.
struct ExpandConfig {
  double cruise = 0;                     // m/s, when the way is free
  double gain = 1;                       // rad/s of turn per rad of bearing to free space
  double free_angle = 0.5;               // rad, drives only while free space is no further off than this
  std::span<const Clearance> clearance;  // by bearing; beams beyond the last do not matter
  double looks = geom::kTwoPi;           // rad, to either side; beams beyond are not looked at
  double flock = 0;     // rad/s of turn per rad that the nearest marker in view is turned off, on a free way
  double restless = 0;  // rad/s; where the way is not free, a turn to the right or slower is drawn instead
};

// Stage has one number for each sensor of its ring. Here it holds halfway to the next sensor, for any ring.
inline constexpr Clearance kSwarmClearance[] = {  // sensors at 0, 30, 60 and 90 degrees
    {geom::radians(15), 0.5f},
    {geom::radians(45), 0.5f / 1.5f},
    {geom::radians(75), 0.5f / 3},
    {geom::radians(105), 0.5f / 5}};
inline constexpr Clearance kPioneerClearance[] = {  // sonars at 10, 30 and 50 degrees; the next is at 90
    {geom::radians(20), 0.75f},
    {geom::radians(40), 0.75f / 2},
    {geom::radians(70), 0.75f / 4}};

inline constexpr Clearance kFlockClearance[] = {  // the same sonars
    {geom::radians(20), 1.0f},
    {geom::radians(70), 0.5f}};

inline constexpr ExpandConfig kExpandSwarm{.cruise = 0.3, .clearance = kSwarmClearance};
inline constexpr ExpandConfig kExpandPioneer{.cruise = 0.2, .clearance = kPioneerClearance};
inline constexpr ExpandConfig kPioneerFlocking{.cruise = 0.4,
                                               .gain = 0.3,
                                               .clearance = kFlockClearance,
                                               .looks = geom::radians(100),
                                               .flock = 0.3,
                                               .restless = 0.1};

class Expand final : public BatchOf<Expand> {
 public:
  Expand(std::string name, const ExpandConfig& config) : BatchOf(std::move(name)), config_(config) {}

  void decide(world::World& world, std::size_t begin, std::size_t end) override;

 private:
  friend BatchOf<Expand>;
  static auto memory(auto& self) { return std::tie(self.seen_); }
  /// Uses the ranger with the most sensors (the ring), the first of equals, and who flocks its first fiducial
  /// finder, if it has one.
  Result<void> join(world::World& world, const Post& post) override;
  void leave_rest(std::size_t i) { erase_at(i, stream_, robot_, ranger_, finder_, first_beam_, ring_); }
  void resolve(const world::World& world, std::size_t i) override;
  void find_rows(const world::World& world, world::ModelRow model, std::size_t i);

  /// What follows from the directions of a ring's beams; shared by all robots with the same ring.
  struct Ring {
    std::vector<float> x, y;   // direction of each beam in the robot's frame
    std::vector<float> clear;  // m, each beam must be longer than this to drive on; below 0: any will do
  };
  std::uint32_t ring_of(const std::vector<float>& bearings);
  /// How far the nearest marker that robot i sees is turned off its own heading; 0 if it sees none. [rad]
  double off_neighbour(const world::World& world, std::size_t i) const;

  ExpandConfig config_;
  std::vector<Ring> rings_;
  std::map<std::vector<float>, std::uint32_t> ring_by_bearings_;

  std::vector<std::uint32_t> ring_;
  std::vector<Stream> stream_;

  // Rows of a robot, of its ring and of its finder, if it uses one.
  std::vector<world::PositionRow> robot_;
  std::vector<world::RangerRow> ranger_;
  std::vector<world::FiducialRow> finder_;
  std::vector<std::uint32_t> first_beam_;

  // Memory.
  std::vector<std::uint64_t> seen_;  // tick of the last scan acted on
};

}  // namespace playhouse::controllers
