// The planner of a GoalAlgorithm: its path is the way to the goal, which the algorithm finds as it goes.

#include <cmath>

#include "playhouse/drivers/algorithm/goal_algorithm.h"
#include "playhouse/drivers/algorithm/planner_device.h"
#include "playhouse/drivers/shapes.h"

namespace playhouse::drivers {

namespace planner = wire::planner;

void GoalAlgorithm::offer_planner(std::size_t device) {
  planner_ = device;
  serve_planner(shell_, device,
                {.take_goal =
                     [this](const planner::Cmd& command, bool start) {
                       return take_goal({command.goal, {}, 1}, start);
                     },
                 .waypoints = [this] { return waypoints(); },
                 .enable = [this](bool enabled) { enable(enabled); }});
}

/// Stops the robot and keeps the goal, or lets it go on.
void GoalAlgorithm::enable(bool enabled) {
  bool was_driving = false;
  {
    const std::lock_guard lock(mutex_);
    was_driving = goal_ && enabled_;
    enabled_ = enabled;
  }
  if (enabled || !was_driving) return;
  shell_.drop_steps();
  drive(0, 0);
}

planner::Data GoalAlgorithm::planner_state() const {
  const std::lock_guard lock(mutex_);
  planner::Data data;
  data.waypoint_idx = -1;
  if (state_) data.pos = state_->pos;
  if (!X_OD_) return data;
  data.goal = pose2d(*X_OD_);
  data.valid = goal_ || done_ ? 1 : 0;
  data.done = done_ ? 1 : 0;
  data.waypoints_count = data.valid;
  if (!goal_) return data;
  data.waypoint = data.goal;
  data.waypoint_idx = 0;
  return data;
}

/// The goal, as far as the robot is from it now.
planner::WaypointsReq GoalAlgorithm::waypoints() const {
  const std::lock_guard lock(mutex_);
  planner::WaypointsReq answer;
  if (!goal_ || !state_) return answer;
  const geom::Vec2 way{goal_->X_OG.x - state_->pos.px, goal_->X_OG.y - state_->pos.py};
  answer.waypoints_distance = std::sqrt(geom::dot(way, way));
  answer.waypoints.push_back(pose2d(goal_->X_OG));
  return answer;
}

}  // namespace playhouse::drivers
