#include "playhouse/web_server/driven_robots.h"

#include "playhouse/base/limits.h"

namespace playhouse::web_server {

void DrivenRobots::drive(const replicate::Drive& drive, DrivingViewer driver) {
  const world::ModelId robot = drive.model;
  const geom::Twist velocity = velocity_of(drive);
  if (velocity == geom::Twist{}) {
    if (held_.contains(robot)) let_go(robot);
    return;
  }
  Held& held = held_[robot];
  held.driver = driver;
  if (!held.use) {
    auto use = std::make_shared<world::Use>();
    const auto open = [use, robot, &control = control_](world::Journal& journal) {
      use->begin(journal, control, robot);
    };
    if (control_.post(open, robot)) held.use = std::move(use);
  }
  control_.drive(robot, velocity);
  hold_until_deadline(robot, held);
}

void DrivenRobots::left(DrivingViewer driver) {
  std::vector<world::ModelId> left;
  for (const auto& [robot, held] : held_) {
    if (held.driver == driver) left.push_back(robot);
  }
  for (const world::ModelId robot : left) let_go(robot);
}

void DrivenRobots::hold_until_deadline(world::ModelId robot, Held& held) {
  held.deadline = network_.after(limits::kViewerDriveSeconds, [this, robot] { let_go(robot); });
}

/// Retries if the queue is full.
void DrivenRobots::let_go(world::ModelId robot) {
  Held& held = held_[robot];
  control_.drive(robot, {});
  const auto close = [use = held.use, &control = control_](world::Journal& journal) {
    use->end(journal, control);
  };
  if (held.use && !control_.post(close, robot)) return hold_until_deadline(robot, held);
  held_.erase(robot);
}

}  // namespace playhouse::web_server
