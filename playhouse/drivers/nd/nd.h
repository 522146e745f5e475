#pragma once

/// The .cfg driver "nd": drives a robot to goals with obstacle avoidance by laser, sonar or both (nd_step.h).

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/goal_driver.h"
#include "playhouse/drivers/nd/nd_step.h"
#include "playhouse/drivers/site.h"
#include "playhouse/scene/cfg.h"

namespace playhouse::drivers {

Result<std::unique_ptr<device::Driver>> make_nd(const scene::CfgSection& section, Site& site);

class Nd final : public GoalDriver {
 public:
  /// Indices of the client's devices.
  struct Devices {
    std::size_t output = 0;                   // gets the velocities
    std::size_t input = 0;                    // gives the pose; may be the output
    std::optional<std::size_t> laser, sonar;  // one of them at least
    std::size_t count = 1;
  };

  /// Its client opens the devices while the device is open.
  Nd(device::Opener& opener, const Devices& devices, NdOptions options);

  AlgorithmThread& thread() override { return thread_; }
  std::string_view name() const override { return "nd"; }

 private:
  void ask_geometry() override;
  void take_scans() override;
  void take_body(const AnswerBody& body);
  void take_laser_geometry(const AnswerBody& body);
  void take_sonar_geometry(const AnswerBody& body);
  std::optional<NdRobot> robot() const;

  const Devices devices_;
  const NdOptions options_;
  device::Subscription* laser_ = nullptr;  // null: not used
  device::Subscription* sonar_ = nullptr;
  NdMemory memory_;  // of the thread

  // Guarded by mutex_, once the geometry of the robot, the laser, the sonars is known.
  std::optional<geom::Box> body_;
  std::optional<geom::Pose> X_RS_;
  std::optional<std::vector<geom::Pose>> sonars_;

  AlgorithmThread thread_;
};

}  // namespace playhouse::drivers
