#include "playhouse/world/gripper.h"

namespace playhouse::world {

void command_gripper(World& world, GripperRow gripper, GripperCommand command) {
  std::int32_t& closing = world.grippers.closing[gripper.index];
  std::int32_t& rising = world.grippers.rising[gripper.index];
  switch (command) {
    case GripperCommand::kOpen:
      closing = -1;
      return;
    case GripperCommand::kClose:
      closing = 1;
      return;
    case GripperCommand::kRaise:
      rising = 1;
      return;
    case GripperCommand::kLower:
      rising = -1;
      return;
    case GripperCommand::kStop:
      closing = rising = 0;
      return;
  }
}

PaddleState paddle_state(const Grippers& grippers, GripperRow gripper) {
  const double paddles = grippers.paddles[gripper.index];
  const std::int32_t closing = grippers.closing[gripper.index];
  if (closing < 0) return PaddleState::kMoving;
  if (paddles >= grippers.close_limit[gripper.index]) return PaddleState::kClosed;
  if (closing > 0) return PaddleState::kMoving;
  return paddles <= 0 ? PaddleState::kOpen : PaddleState::kStopped;
}

ModelRow held_by(const World& world, GripperRow gripper) {
  const ModelRow held = world.row(world.grippers.held[gripper.index]);
  const ModelId own = world.id(world.grippers.model[gripper.index]);
  return held && world.models.parent_id[held.index] == own ? held : ModelRow{};
}

}  // namespace playhouse::world
