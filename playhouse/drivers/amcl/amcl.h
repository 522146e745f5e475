#pragma once

/// The .cfg driver "amcl": where a robot is on a map, by its odometry and its laser or sonars. Provides
/// localize, the hypotheses and particles, and position2d, the odometry corrected to the map.
/// The filter (particle_filter.h) runs on a thread of its own, whenever the robot has moved.

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/device/client.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/algorithm_thread.h"
#include "playhouse/drivers/amcl/particle_filter.h"
#include "playhouse/drivers/site.h"
#include "playhouse/scene/cfg.h"
#include "playhouse/wire/generated/localize.h"

namespace playhouse::drivers {

Result<std::unique_ptr<device::Driver>> make_amcl(const scene::CfgSection& section, Site& site);

class Amcl final : public device::Driver {
 public:
  enum class Sensor : std::uint8_t { kLaser, kSonar };

  /// Its client opens the odometry, the sensor and the map, in this order, while a device is open.
  Amcl(device::Opener& opener, const AmclOptions& options, Sensor sensor);

  /// Its devices; position2d may be missing.
  void set_devices(device::DeviceId localize, std::optional<device::DeviceId> position) {
    localize_ = localize;
    position_ = position;
  }
  /// Of random numbers.
  void set_seed(std::uint64_t seed) { seed_ = seed; }
  device::DeviceClient& client() { return client_; }
  AlgorithmThread& thread() { return thread_; }

  std::string_view name() const override { return "amcl"; }
  Result<void> start(device::DeviceId device) override;
  void stop(device::DeviceId device) override;
  void retired(device::DeviceId device) override;
  /// The world was rewound to `time` [s] or restarted with a seed: goes on with what was believed then.
  /// Tick thread.
  void rewound(double time, std::uint64_t seed);
  /// The world put the robot elsewhere, as by its RESET: if its odometry changes, it is right. Tick thread.
  void placed();
  device::Taken command(const device::Message&) override { return device::Taken::kNo; }
  void request(const device::Message& message, device::Replier replier) override;
  bool capable(device::DeviceId device, std::uint8_t type, std::uint8_t subtype) const override;
  void barrier(device::Replier replier) override { client_.barrier(std::move(replier)); }

 private:
  /// What was believed when the odometry was at X_OR.
  struct Estimate {
    double time = 0;  // s
    geom::Pose X_OS;  // X_OS_ of then
    geom::Pose X_OR;
    PoseBelief belief;  // the heaviest hypothesis
  };

  void ask_geometry();
  void ask_map();
  void take_news(std::vector<device::Publication>& more);
  void take_state(const device::Publication& message, std::vector<device::Publication>& more);
  void take_odometry(const geom::Pose& X_SR, const wire::Pose2d& velocity, double time);
  void take_scan(const device::Publication& message);
  std::vector<geom::Vec2> hits_of(const device::Publication& message) const;
  bool is_due() const;
  FilterOut step(std::uint64_t run, const PoseBelief& start, const geom::Pose& X_OR,
                 std::shared_ptr<const GridMap> map, FilterIn in);
  void deliver(std::uint64_t run, Estimate at, FilterOut out);
  void begin_anew(const PoseBelief& start, std::optional<Estimate> estimate);
  geom::Pose moved(const geom::Pose& X_WR) const;
  bool set_pose(const device::Message& message);
  wire::localize::Data hypotheses() const;
  wire::localize::GetParticles particles() const;

  const AmclOptions options_;
  const Sensor sensor_;
  device::DeviceClient client_;
  device::Subscription& odometry_;
  device::Subscription& scans_;
  device::DeviceId localize_;
  std::optional<device::DeviceId> position_;
  int open_ = 0;  // own devices; io thread

  // Of the thread.
  FilterMemory memory_;
  std::uint64_t memory_run_ = 0;
  geom::Pose memory_X_OR_;
  std::shared_ptr<const GridMap> field_map_;
  std::optional<LikelihoodField> field_;  // of that map

  mutable std::mutex mutex_;  // guards what follows
  std::uint64_t seed_ = 0;
  std::shared_ptr<const GridMap> map_;      // once it is known
  std::vector<geom::Pose> X_RS_;            // laser or sonars; empty until they are known
  std::optional<geom::Pose> X_OR_;          // latest odometry, without jumps
  std::optional<geom::Pose> X_SR_;          // the same as it was told
  double odometry_time_ = 0;                // s
  bool placed_ = false;                     // since then
  geom::Pose X_OS_;                         // its frame, after the latest jump
  std::uint64_t run_ = 1;                   // of the filter; results of earlier ones are discarded
  std::uint64_t steps_ = 0;                 // of this run
  PoseBelief start_;                        // of this run
  std::optional<geom::Pose> X_OR_stepped_;  // odometry of the latest step; none: none in this run
  std::optional<Estimate> estimate_;        // once the odometry is known
  FilterOut out_;                           // of the latest step; empty before the first of this run
  std::deque<Estimate> history_;            // for rewinds, oldest first

  AlgorithmThread thread_;  // last member: joined before what it uses is destroyed
};

}  // namespace playhouse::drivers
