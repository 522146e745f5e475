#pragma once

/// The .cfg driver "goto": drives a robot straight to goals, and into what is in the way.
///
/// In: the robot's pose and the goal's.
///
/// Out: it turns towards the goal, drives there, and turns to the goal's heading. The farther away, the faster.

#include <cstdint>
#include <optional>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/drivers/algorithm/goal_algorithm.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/section_fields.h"
#include "playhouse/geom/trig.h"

namespace playhouse::drivers {

struct GotoOptions {
  double distance = 0.04, angle = geom::radians(3);  // m, rad; tolerances of arrival
};

struct GotoStep {
  double speed = 0, turn_rate = 0;  // m/s, rad/s
  bool done = false;
};

Result<GotoOptions> goto_options(SectionFields fields);
/// `is_there`: it has been at the goal, and turns there.
GotoStep goto_step(const GotoOptions& options, const geom::Pose& X_OR, const geom::Pose& X_OG, bool is_there);

/// Uses the robot; may provide a dio, whose first bit is 1 once the robot has arrived, until the next goal.
class Goto final : public GoalAlgorithm {
 public:
  Goto(Shell& shell, const GotoOptions& options);

  void take_news(std::vector<device::Publication>& more) override;

 private:
  static constexpr std::size_t kDio = 1;  // provided device

  void ask_geometry() override {}
  void take_scans() override;

  const GotoOptions options_;
  device::Subscription& states_;

  // Of the publishing thread.
  std::uint64_t drive_ = 0;
  std::optional<geom::Pose> X_OG_;
  bool is_there_ = false, arrived_ = false;
};

extern const DriverDefinition kGotoDriver;

}  // namespace playhouse::drivers
