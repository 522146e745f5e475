#pragma once

/// PositionGuard: base of drivers that stand before a robot and keep commands from it, or stop it: a position2d in front
/// of another one, whose data and answers are its own.

#include <mutex>
#include <optional>

#include "playhouse/drivers/algorithm/forwarder.h"

namespace playhouse::drivers {

/// What a command makes a robot do.
struct CommandedMotion {
  double ahead = 0;      // m/s
  bool stands = false;   // it stops the robot
  bool to_goal = false;  // a pose: the robot may move in any direction
};
/// None of what is no command of position2d.
std::optional<CommandedMotion> motion_of(const device::Message& command);

class PositionGuard : public Forwarder {
 public:
  explicit PositionGuard(Shell& shell) : Forwarder(shell) {}

  /// Stops what it let move: nobody looks after it from now on.
  void closing() override;

 protected:
  /// With mutex_ held.
  virtual bool forbids(const CommandedMotion& motion) const = 0;
  /// There is a command. With mutex_ held.
  virtual void hear_command() {}
  /// Stops the robot if what it was told last is forbidden by now. Not with mutex_ held.
  void look_again();

  mutable std::mutex mutex_;  // guards what a subclass knows, and what follows

 private:
  device::Taken take(const device::Message& message) override;
  void stop();

  std::optional<CommandedMotion> moving_;  // by the last command
};

}  // namespace playhouse::drivers
