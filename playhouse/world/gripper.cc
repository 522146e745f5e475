#include "playhouse/world/gripper.h"

namespace playhouse::world {

void command_gripper(World& world, GripperRow gripper, GripperCommand command) {
  std::int32_t& closing = world.grippers.closing[gripper];
  std::int32_t& rising = world.grippers.rising[gripper];
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
  const double paddles = grippers.paddles[gripper];
  const std::int32_t closing = grippers.closing[gripper];
  if (closing < 0) return PaddleState::kMoving;
  if (paddles >= grippers.close_limit[gripper]) return PaddleState::kClosed;
  if (closing > 0) return PaddleState::kMoving;
  return paddles <= 0 ? PaddleState::kOpen : PaddleState::kStopped;
}

ModelRow held_by(const World& world, GripperRow gripper) {
  const ModelRow held = world.row(world.grippers.held[gripper]);
  const ModelId own = world.id(world.grippers.model[gripper]);
  return held && world.models.parent_id[held] == own ? held : ModelRow{};
}

}  // namespace playhouse::world
