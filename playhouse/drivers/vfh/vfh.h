#pragma once

/// The .cfg driver "vfh": drives a robot to goals with obstacle avoidance by laser, ranger or sonar
/// (vfh_step.h).

#include <cstddef>
#include <memory>
#include <optional>

#include "playhouse/base/result.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/algorithm/goal_algorithm.h"
#include "playhouse/drivers/algorithm/scan_reader.h"
#include "playhouse/drivers/site.h"
#include "playhouse/drivers/vfh/vfh_step.h"

namespace playhouse::drivers {

Result<std::unique_ptr<device::Driver>> make_vfh(const config::CfgSection& section, Site& site);

/// Uses the robot and the device of its scans, in this order.
class Vfh final : public GoalAlgorithm {
 public:
  Vfh(Shell& shell, const VfhOptions& options, ScanInterface scans);

 private:
  static constexpr std::size_t kPlanner = 1;            // of the provided devices; may be none
  static constexpr std::size_t kRobot = 0, kScans = 1;  // used devices

  void ask_geometry() override;
  void take_scans() override;
  bool is_usable_state(const wire::position2d::Data& state) const override;

  const VfhOptions options_;
  ScanReader scans_;
  VfhMemory memory_;  // of the thread

  std::optional<double> radius_;  // m; once the robot's geometry is known; guarded by mutex_
};

}  // namespace playhouse::drivers
