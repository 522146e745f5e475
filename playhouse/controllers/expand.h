#pragma once

/// expand_swarm and expand_pioneer: robots disperse, each towards the mean direction of
/// free space around it. pioneer_flocking: they also align with their neighbours'
/// headings. For any ring of range sensors. Constants of Stage; see docs/controllers.md.

#include <map>
#include <span>

#include "playhouse/base/rng.h"
#include "playhouse/controllers/batch.h"

namespace playhouse::controllers {

/// Minimum free range for the robot to drive, by bearing: less to the sides than ahead.
struct Clearance {
  double up_to;       // rad, bearing limit on either side; starts at that of the previous entry
  float longer_than;  // m
};

/// Parameters of dispersal.
struct ExpandConfig {
  double cruise = 0;                     // m/s, if unobstructed
  double gain = 1;                       // turn rate in rad/s per rad of bearing to free space
  double free_angle = 0.5;               // rad, drives only while the bearing to free space is smaller
  std::span<const Clearance> clearance;  // ascending; beams beyond the last are ignored
  double looks = geom::kTwoPi;           // rad, to either side; beams beyond are ignored
  double flock = 0;     // rad/s per rad of heading difference to the nearest visible marker, if unobstructed
  double restless = 0;  // rad/s; if obstructed, turns slower than this are random ones to the left
};

// Stage has a constant per sensor of its ring; here each applies halfway to the next sensor, for any ring.
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
    {geom::radians(40), 1.0f},
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
  /// Uses the ranger with the most sensors (the ring), the first of
  /// several; flocking robots also their first fiducial finder, if any.
  Result<void> join(world::World& world, const Post& post) override;
  void leave_rest(std::size_t i) { erase_at(i, stream_, robot_, ranger_, finder_, first_beam_, ring_); }
  void resolve(const world::World& world, std::size_t i) override;
  void find_rows(const world::World& world, world::ModelRow model, std::size_t i);

  /// Precomputed for a ring's beam directions; shared by robots with equal rings.
  struct ExpandRing {
    std::vector<float> x, y;   // direction of each beam in the robot's frame
    std::vector<float> clear;  // m, minimum free range of each beam; negative: ignored
  };
  std::uint32_t ring_of(const std::vector<float>& bearings);
  /// Heading difference of robot i to the nearest visible marker; 0 if there is none. [rad]
  double off_neighbour(const world::World& world, std::size_t i) const;

  ExpandConfig config_;
  std::vector<ExpandRing> rings_;
  std::map<std::vector<float>, std::uint32_t> ring_by_bearings_;

  std::vector<std::uint32_t> ring_;
  std::vector<Stream> stream_;

  // Rows of a robot, of its ring, and of its finder, if used.
  std::vector<world::PositionRow> robot_;
  std::vector<world::RangerRow> ranger_;
  std::vector<world::FiducialRow> finder_;
  std::vector<world::BeamRow> first_beam_;

  // Memory.
  std::vector<std::uint64_t> seen_;  // tick of the last scan acted on
};

}  // namespace playhouse::controllers
