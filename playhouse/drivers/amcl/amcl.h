#pragma once

/// The .cfg driver "amcl": where a robot is on a map, by its odometry and its laser, ranger or sonars. Provides
/// localize, the hypotheses and particles, and position2d, the odometry corrected to the map.
/// The filter (particle_filter.h) runs on a thread of its own, whenever the robot has moved.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/algorithm/scan_reader.h"
#include "playhouse/drivers/algorithm/shell.h"
#include "playhouse/drivers/amcl/particle_filter.h"
#include "playhouse/drivers/site.h"
#include "playhouse/wire/generated/localize.h"

namespace playhouse::drivers {

Result<std::unique_ptr<device::Driver>> make_amcl(const config::CfgSection& section, Site& site);

/// Provides localize and maybe position2d; uses the odometry, the device of scans and the map, in this order.
class Amcl final : public Algorithm {
 public:
  Amcl(Shell& shell, const AmclOptions& options, ScanInterface scans);

  void opened() override;
  void take_news(std::vector<device::Publication>& more) override;
  /// Goes on with what was believed then.
  void rewound(const Moment& moment) override;
  /// If the odometry changes now, it is right.
  void placed() override;

 private:
  static constexpr std::size_t kLocalize = 0, kPosition = 1;         // provided devices
  static constexpr std::size_t kOdometry = 0, kScans = 1, kMap = 2;  // used devices

  /// What was believed when the odometry was at X_OR.
  struct Estimate {
    double time = 0;  // s
    geom::Pose X_OS;  // X_OS_ of then
    geom::Pose X_OR;
    PoseBelief belief;  // the heaviest hypothesis
  };

  void take_state(const device::Publication& message, std::vector<device::Publication>& more);
  void take_odometry(const geom::Pose& X_SR, const wire::Pose2d& velocity, double time);
  void take_scan(const RangeScan& scan, double time);
  std::vector<geom::Vec2> hits_of(const RangeScan& scan) const;
  bool is_due() const;
  FilterOut step(std::uint64_t run, const PoseBelief& start, const geom::Pose& X_OR,
                 std::shared_ptr<const GridMap> map, FilterIn in);
  void deliver(std::uint64_t run, Estimate at, FilterOut out);
  void begin_anew(const PoseBelief& start, std::optional<Estimate> estimate);
  geom::Pose moved(const geom::Pose& X_WR) const;
  AnswerBody set_pose(const wire::localize::SetPose& pose);
  wire::localize::Data hypotheses() const;
  wire::localize::GetParticles particles() const;

  Shell& shell_;
  const AmclOptions options_;
  device::Subscription& odometry_;
  ScanReader scans_;

  // Of the thread.
  FilterMemory memory_;
  std::uint64_t memory_run_ = 0;
  geom::Pose memory_X_OR_;
  std::shared_ptr<const GridMap> field_map_;
  std::optional<LikelihoodField> field_;  // of that map

  mutable std::mutex mutex_;                // guards what follows
  std::shared_ptr<const GridMap> map_;      // once it is known
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
};

}  // namespace playhouse::drivers
