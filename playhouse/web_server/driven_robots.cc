#include "playhouse/web_server/driven_robots.h"

#include "playhouse/base/limits.h"

namespace playhouse::web_server {

DrivenRobots::DrivenRobots(net::Network& network, world::Control& control, const world::World& world)
    : network_(network), control_(control), wheels_(world.models.size()) {
  for (std::uint32_t robot = 0; robot < world.positions.size(); ++robot)
    wheels_[world.positions.model[robot].index] = {robot};
}

Result<void> DrivenRobots::drive(const replicate::Drive& drive, Driver driver) {
  const world::PositionRow robot = drive.model < wheels_.size() ? wheels_[drive.model] : world::PositionRow{};
  if (!robot) return Error{"", "no such robot to drive"};
  if (drive.velocity == geom::Twist{}) {
    if (held_.contains(robot.index)) let_go(robot);
    return {};
  }
  Held& held = held_[robot.index];
  held.model = {drive.model};
  held.driver = driver;
  if (!held.open) {
    held.open =
        control_.post([model = held.model](world::World& world) { world::subscribe(world, model); }, robot);
  }
  control_.drive(robot, drive.velocity);
  hold_until_deadline(robot, held);
  return {};
}

void DrivenRobots::left(Driver driver) {
  std::vector<std::uint32_t> left;
  for (const auto& [robot, held] : held_) {
    if (held.driver == driver) left.push_back(robot);
  }
  for (const std::uint32_t robot : left) let_go({robot});
}

void DrivenRobots::hold_until_deadline(world::PositionRow robot, Held& held) {
  held.deadline = network_.after(limits::kViewerDriveSeconds, [this, robot] { let_go(robot); });
}

/// What the tick's queue has no room for is tried again.
void DrivenRobots::let_go(world::PositionRow robot) {
  Held& held = held_[robot.index];
  control_.drive(robot, {});
  const auto close = [model = held.model](world::World& world) { world::unsubscribe(world, model); };
  if (held.open && !control_.post(close, robot)) return hold_until_deadline(robot, held);
  held_.erase(robot.index);
}

}  // namespace playhouse::web_server
