#pragma once

/// A planner that an algorithm provides: its commands and requests, decoded.

#include <cstddef>
#include <functional>

#include "playhouse/drivers/algorithm/shell.h"
#include "playhouse/wire/generated/planner.h"

namespace playhouse::drivers {

struct PlannerCalls {
  /// `start`: START, which enables, too; otherwise GOAL.
  std::function<device::Taken(const wire::planner::Cmd& command, bool start)> take_goal;
  std::function<wire::planner::WaypointsReq()> waypoints;
  std::function<void(bool enabled)> enable;
};

/// `device`: its number among those provided. For the constructor of an algorithm.
void serve_planner(Shell& shell, std::size_t device, PlannerCalls calls);

}  // namespace playhouse::drivers
