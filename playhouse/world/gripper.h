#pragma once

/// What grippers are told, and what can be told of them. Thread: the tick thread, between steps.

#include "playhouse/world/world.h"

namespace playhouse::world {

enum class GripperCommand : std::uint8_t { kOpen, kClose, kRaise, kLower, kStop };

/// What it is to do from now on; paddles and lift move while somebody subscribes it.
void command_gripper(World& world, GripperRow gripper, GripperCommand command);

enum class PaddleState : std::uint8_t {
  kOpen,
  kClosed,  // as far as they can, perhaps around a thing
  kMoving,
  kStopped,  // between the two
};

PaddleState paddle_state(const Grippers& grippers, GripperRow gripper);

/// What it holds now; none also where that has gone, or was taken from it.
ModelRow held_by(const World& world, GripperRow gripper);

}  // namespace playhouse::world
