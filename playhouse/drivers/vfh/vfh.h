#pragma once

/// The .cfg driver "vfh": drives a robot to goals with obstacle avoidance by laser (vfh_step.h).

#include <memory>
#include <optional>
#include <string_view>

#include "playhouse/base/result.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/goal_driver.h"
#include "playhouse/drivers/site.h"
#include "playhouse/drivers/vfh/vfh_step.h"
#include "playhouse/scene/cfg.h"

namespace playhouse::drivers {

Result<std::unique_ptr<device::Driver>> make_vfh(const scene::CfgSection& section, Site& site);

class Vfh final : public GoalDriver {
 public:
  /// Its client opens the robot and its laser, in this order, while the device is open.
  Vfh(device::Opener& opener, const VfhOptions& options);

  AlgorithmThread& thread() override { return thread_; }
  std::string_view name() const override { return "vfh"; }

 private:
  void ask_geometry() override;
  void take_scans() override;
  bool is_usable_state(const wire::position2d::Data& state) const override;

  const VfhOptions options_;
  device::Subscription& scans_;
  VfhMemory memory_;  // of the thread

  // Guarded by mutex_.
  std::optional<double> radius_;    // m; once the robot's geometry is known
  std::optional<geom::Pose> X_RS_;  // once the laser's geometry is known

  AlgorithmThread thread_;
};

}  // namespace playhouse::drivers
