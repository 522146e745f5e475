#pragma once

/// The .cfg driver "deadstop": stops a robot that is told nothing any more.

#include <optional>

#include "playhouse/base/result.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/motion/position_guard.h"
#include "playhouse/drivers/section_fields.h"

namespace playhouse::drivers {

struct DeadStopOptions {
  double timeout = 0.5;  // s
};

Result<DeadStopOptions> dead_stop_options(SectionFields fields);

/// Time is that of the robot's data. A command counts as given at the data after it, so that the robot stops no sooner
/// than the timeout after a command, and one period of its data later at most.
class DeadStop final : public PositionGuard {
 public:
  DeadStop(Shell& shell, const DeadStopOptions& options) : PositionGuard(shell), options_(options) {}

  void opened() override;
  void take_news(std::vector<device::Publication>& more) override;

 private:
  bool forbids(const CommandedMotion&) const override;
  void hear_command() override { told_ = true; }
  std::optional<device::Publication> passed(device::Publication message) override;

  const DeadStopOptions options_;

  // Guarded by mutex_.
  bool told_ = false;                   // since the newest data
  double now_ = 0;                      // s
  std::optional<double> told_at_ = {};  // s
};

extern const DriverDefinition kDeadStopDriver;

}  // namespace playhouse::drivers
