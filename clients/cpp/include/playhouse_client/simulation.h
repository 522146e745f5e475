#pragma once

/// The simulator itself: poses of models by their full names, each in its parent's frame, which is the world
/// for a model that nothing carries. SI units and radians.

#include <string_view>

#include "playhouse/wire/generated/simulation.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"

namespace playhouse::client {

class Simulation {
 public:
  static Result<Simulation> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// An error, which names it, if there is no such model.
  Result<Pose> pose(std::string_view model);
  /// An error also if a number of the pose is not finite.
  Result<void> set_pose(std::string_view model, const Pose& pose);
  Result<Pose3d> pose3d(std::string_view model);
  Result<void> set_pose3d(std::string_view model, const Pose3d& pose);

  /// Stops the clock, or lets it go on.
  Result<void> pause();
  /// Everything back to where the world file has it.
  Result<void> reset();

  Device& device() { return device_; }

 private:
  explicit Simulation(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
