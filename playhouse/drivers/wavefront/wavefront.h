#pragma once

/// The .cfg driver "wavefront": plans a path to a goal on a grid map and drives a robot along
/// it, by giving its waypoints to a position2d that goes to them (follow_path.h, on a thread of
/// its own), round what its laser, ranger or sonars see that is not on the map, if it has any. Frames: W of the map
/// and of the input's poses, O of the output's poses.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/algorithm/recent_poses.h"
#include "playhouse/drivers/algorithm/scan_reader.h"
#include "playhouse/drivers/algorithm/shell.h"
#include "playhouse/drivers/site.h"
#include "playhouse/drivers/wavefront/follow_path.h"
#include "playhouse/wire/generated/planner.h"

namespace playhouse::drivers {

Result<std::unique_ptr<device::Driver>> make_wavefront(const config::CfgSection& section, Site& site);

/// Uses output, input, map and the device of its scans, if it has one, in this order.
class Wavefront final : public Algorithm {
 public:
  Wavefront(Shell& shell, const WavefrontOptions& options, std::optional<ScanInterface> scans);

  void opened() override;
  void closing() override;
  void closed() override;
  void take_news(std::vector<device::Publication>& more) override;
  /// Plans again, keeps the goal unless the run starts again.
  void rewound(const Moment& moment) override;

 private:
  static constexpr std::size_t kOutput = 0, kInput = 1, kMap = 2, kScans = 3;  // used devices

  struct PlannedGoal {
    geom::Pose X_WT;
    std::uint64_t number = 0;
    std::string no_path{}, no_drive{};  // why it is refused (refusal.h), both logged
    std::optional<geom::Pose> X_WR{};   // where the robot was when there was no path
  };
  void read_map_again();
  void take_map(std::uint64_t reading, Result<GridMap> map);
  device::Taken take_command(const wire::planner::Cmd& command, bool start);
  void set_goal(const geom::Pose& X_WT, bool start);
  bool may_have_path_now() const;
  void enable(bool enabled);
  bool end_drive();
  std::optional<FollowIn> next_step(double time) const;
  std::optional<PlacedScan> newest_scan() const;
  void post(FollowIn in);
  void take_step(std::uint64_t goal, const FollowOut& out);
  void go_to(std::uint64_t goal, const geom::Pose& X_OP, bool again);
  void take_drive(std::uint64_t goal, const std::string& no_drive);
  std::string refusal();
  void halt();
  wire::planner::Data state() const;
  wire::planner::WaypointsReq waypoints();

  Shell& shell_;
  const WavefrontOptions options_;
  device::Subscription& output_states_;
  device::Subscription& input_states_;
  std::optional<ScanReader> scans_;
  FollowMemory memory_;  // of the thread

  mutable std::mutex mutex_;  // guards what follows
  std::optional<PlannedGoal> goal_;
  std::uint64_t goals_ = 0;  // so far
  std::string unusable_;     // why a goal after that one was refused; empty: there was none
  bool enabled_ = true;
  bool driving_ = false;  // the output is on its way to a waypoint
  FollowOut progress_;    // to the goal
  std::optional<geom::Pose> X_WR_, X_OR_;
  RecentPoses recent_;     // X_WR_
  bool has_scan_ = false;  // that came since the latest of them
  std::shared_ptr<const GridMap> map_;
  std::string map_fault_;       // why there is no map, after it was read
  bool reading_ = false;        // the map
  std::uint64_t readings_ = 0;  // so far
};

}  // namespace playhouse::drivers
