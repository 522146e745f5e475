#include "playhouse/drivers/motion/position_guard.h"

#include <utility>

#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {

namespace p2d = wire::position2d;

namespace {

template <typename Command, typename MotionOf>
std::optional<CommandedMotion> decoded_motion(const device::Message& message, MotionOf motion) {
  const Result<Command> command = wire::decode<Command>(message.body);
  if (!command) return std::nullopt;
  return motion(*command);
}

}  // namespace

std::optional<CommandedMotion> motion_of(const device::Message& command) {
  switch (command.subtype) {
    case p2d::kCmdVel:
      return decoded_motion<p2d::CmdVel>(command, [](const p2d::CmdVel& told) {
        return CommandedMotion{told.vel.px, told.vel == wire::Pose2d{}, false};
      });
    case p2d::kCmdCar:
      return decoded_motion<p2d::CmdCar>(command, [](const p2d::CmdCar& told) {
        return CommandedMotion{told.velocity, told == p2d::CmdCar{}, false};
      });
    case p2d::kCmdVelHead:
      return decoded_motion<p2d::CmdVelHead>(command, [](const p2d::CmdVelHead& told) {
        return CommandedMotion{told.velocity, false, false};
      });
    case p2d::kCmdPos:
      return decoded_motion<p2d::CmdPos>(command, [](const p2d::CmdPos&) {
        return CommandedMotion{0, false, true};
      });
    default:
      return std::nullopt;
  }
}

device::Taken PositionGuard::take(const device::Message& message) {
  const std::optional<CommandedMotion> motion = motion_of(message);
  if (!motion) return device::Taken::kNo;
  {
    const std::lock_guard lock(mutex_);
    hear_command();
    if (!motion->stands && forbids(*motion)) return device::Taken::kNo;
  }
  const device::Taken taken = forward(message);
  {
    const std::lock_guard lock(mutex_);
    moving_ = motion->stands ? std::nullopt : motion;
  }
  look_again();  // it may have been forbidden meanwhile
  return taken;
}

void PositionGuard::look_again() {
  {
    const std::lock_guard lock(mutex_);
    if (!moving_ || !forbids(*moving_)) return;
    moving_.reset();
  }
  stop();
}

void PositionGuard::closing() {
  {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(moving_, std::nullopt)) return;
  }
  stop();
}

void PositionGuard::stop() {
  shell_.client().command(kForwarded, p2d::kCmdVel, wire::encode(p2d::CmdVel{{}, 1}));
}

}  // namespace playhouse::drivers
