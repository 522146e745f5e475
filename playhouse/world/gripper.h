#pragma once

/// Commands and state of grippers. Thread: the tick thread, between steps.

#include "playhouse/world/world.h"

namespace playhouse::world {

enum class GripperCommand : std::uint8_t { kOpen, kClose, kRaise, kLower, kStop };

/// Sets the command; paddles and lift move only while the gripper is subscribed.
void command_gripper(World& world, GripperRow gripper, GripperCommand command);

enum class PaddleState : std::uint8_t {
  kOpen,
  kClosed,  // as far as possible, maybe around an object
  kMoving,
  kStopped,  // between open and closed
};

PaddleState paddle_state(const Grippers& grippers, GripperRow gripper);

/// The object it holds; none also if that was removed or taken away.
ModelRow held_by(const World& world, GripperRow gripper);

}  // namespace playhouse::world
