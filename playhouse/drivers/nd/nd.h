#pragma once

/// The .cfg driver "nd": drives a robot to goals with obstacle avoidance by laser, ranger, sonar or
/// several of them (nd_step.h).

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/algorithm/goal_algorithm.h"
#include "playhouse/drivers/algorithm/scan_reader.h"
#include "playhouse/drivers/nd/nd_step.h"
#include "playhouse/drivers/site.h"

namespace playhouse::drivers {

Result<std::unique_ptr<device::Driver>> make_nd(const config::CfgSection& section, Site& site);

/// Uses the robot that gets the velocities, the one that gives the pose, maybe the same, and those of scans.
class Nd final : public GoalAlgorithm {
 public:
  Nd(Shell& shell, const NdOptions& options, const std::vector<ScanInterface>& scans);

 private:
  static constexpr std::size_t kOutput = 0, kInput = 1,
                               kScans = 2;  // used devices, from kScans on those of scans

  void ask_geometry() override;
  void take_scans() override;
  void take_body(const AnswerBody& body);

  const NdOptions options_;
  std::deque<ScanReader> scans_;
  NdMemory memory_;  // of the thread

  std::optional<geom::Box> body_;  // once the robot's geometry is known; guarded by mutex_
};

}  // namespace playhouse::drivers
