#pragma once

/// The .cfg driver "bumper_safe": stops a robot whose bumper touches something.

#include <cstdint>
#include <vector>

#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/motion/position_guard.h"

namespace playhouse::drivers {

/// Uses the robot and its bumper. Whoever switches the motors on lets the robot move with the bumpers that are pressed
/// then, until they are released.
class BumperSafe final : public PositionGuard {
 public:
  explicit BumperSafe(Shell& shell);

  void opened() override;
  void take_news(std::vector<device::Publication>& more) override;

 private:
  static constexpr std::size_t kBumper = 1;  // used device

  bool forbids(const CommandedMotion&) const override;
  void take_bumpers(std::vector<std::uint8_t> pressed);

  device::Subscription& bumpers_;

  // Guarded by mutex_; one for each bumper.
  std::vector<std::uint8_t> pressed_, allowed_;
};

extern const DriverDefinition kBumperSafeDriver;

}  // namespace playhouse::drivers
