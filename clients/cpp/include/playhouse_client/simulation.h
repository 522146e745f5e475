#pragma once

/// The simulator itself: poses of models by name, in the frame of the world. SI units and radians.

#include <string_view>

#include "playhouse/wire/generated/simulation.h"
#include "playhouse_client/client.h"

namespace playhouse::client {

class Simulation {
 public:
  static Result<Simulation> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// An error if there is no model of that name.
  Result<wire::Pose2d> pose(std::string_view model);
  Result<void> set_pose(std::string_view model, const wire::Pose2d& pose);
  Result<wire::Pose3d> pose3d(std::string_view model);
  Result<void> set_pose3d(std::string_view model, const wire::Pose3d& pose);

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
