#pragma once

/// The .cfg driver "nd": drives a robot to goals with obstacle avoidance by laser, sonar or both (nd_step.h).

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/algorithm/goal_algorithm.h"
#include "playhouse/drivers/nd/nd_step.h"
#include "playhouse/drivers/site.h"
#include "playhouse/scene/cfg.h"

namespace playhouse::drivers {

Result<std::unique_ptr<device::Driver>> make_nd(const scene::CfgSection& section, Site& site);

/// Uses the robot that gets the velocities, the one that gives the pose, maybe the same, and the sensors.
class Nd final : public GoalAlgorithm {
 public:
  /// Their numbers; one of them at least.
  struct Sensors {
    std::optional<std::size_t> laser, sonar;
  };

  Nd(Shell& shell, const NdOptions& options, const Sensors& sensors);

 private:
  static constexpr std::size_t kOutput = 0, kInput = 1;  // used devices, before the sensors

  void ask_geometry() override;
  void take_scans() override;
  void take_body(const AnswerBody& body);
  std::optional<NdRobot> robot() const;

  const NdOptions options_;
  const Sensors sensors_;
  device::Subscription* laser_ = nullptr;  // null: not used
  device::Subscription* sonar_ = nullptr;
  NdMemory memory_;  // of the thread

  // Guarded by mutex_, once the geometry of the robot, the laser, the sonars is known.
  std::optional<geom::Box> body_;
  std::optional<geom::Pose> X_RS_;
  std::optional<std::vector<geom::Pose>> sonars_;
};

}  // namespace playhouse::drivers
