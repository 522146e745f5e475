#pragma once

/// A planner, which drives a robot to goals on a map. SI units and radians.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/wire/generated/planner.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"

namespace playhouse::client {

/// What a planner reports; poses are on the map.
struct PlannerState {
  bool valid = false;  // there is a path to the goal
  bool done = false;   // the goal is reached
  Pose pose;           // of the robot
  Pose goal;
  Pose waypoint;            // that the robot drives to
  std::int32_t index = 0;   // of that waypoint in the path; -1 if there is none
  std::uint32_t count = 0;  // of the path's waypoints
  double time = 0;          // the server's, of these data [s]
};

/// A planned path.
struct Path {
  std::vector<Pose> waypoints;  // on the map, from the robot to the goal
  double length = 0;            // m
};

/// A planner goes on while any client has it open; wavefront cancels the goal when the last one closes it.
class Planner {
 public:
  static Result<Planner> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// The newest state; none before the first data.
  std::optional<PlannerState> state() const;

  /// Whether the newest data say that the goal of the last go_to() is reached; data of another goal do not
  /// count.
  bool arrived() const;

  /// Plans a path to a pose on the map and drives there; after stop(), from resume() on. An error, and
  /// nothing is sent, if a number is not finite.
  Result<void> go_to(const Pose& pose);

  /// Requests why the planner does not drive to the goal of the last go_to(), as its log says; empty if it
  /// does, has arrived, has not planned yet, or is a driver that gives no reasons.
  Result<std::string> why_refused();

  /// go_to(), and reads the planner's client until the goal is reached. An error as soon as why_refused() has
  /// a reason or the planner has another goal, and after `patience` without data of the planner.
  Result<void> drive_to(Client& client, const Pose& pose, Seconds patience = Seconds(5.0));

  /// Stops the robot until resume(); the planner keeps its goal.
  Result<void> stop();
  Result<void> resume();

  /// Requests the path as it was planned last; without waypoints if there is none.
  Result<Path> path();

  Device& device() { return device_; }

 private:
  friend class RobotDevices;
  explicit Planner(Device device) : device_(std::move(device)) {}
  Result<void> next_data(Client& client, Seconds patience);

  Device device_;
  std::optional<Pose> goal_;  // of the last go_to()
};

}  // namespace playhouse::client
