#pragma once

/// The simulator: poses of models by full name, each in its parent's frame (the world frame for top-level
/// models). SI units and radians.

#include <cstdint>
#include <string>
#include <string_view>

#include "playhouse/wire/generated/simulation.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"

namespace playhouse::client {

class Simulation {
 public:
  static Result<Simulation> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// An error if there is no model of this name.
  Result<Pose> pose(std::string_view model);
  /// Also an error if a number of the pose is not finite.
  Result<void> set_pose(std::string_view model, const Pose& pose);
  Result<Pose3d> pose3d(std::string_view model);
  Result<void> set_pose3d(std::string_view model, const Pose3d& pose);

  /// Pauses or resumes the clock (toggles).
  Result<void> pause();
  /// Restores the poses of the world file; the clock goes on.
  Result<void> reset();
  /// Has the server save the current world to the file given by `playhouse run --save-world`; without that
  /// option it does nothing.
  Result<void> save();

  /// Joins the lock-step of the world under this name, until the connection ends: the world waits for this
  /// client. Open devices first. An error says why it was refused.
  Result<void> join(std::string_view name);
  /// Advances the world by `ticks` and waits until they are done; in lock-step this includes waiting
  /// for the other members. Push mode: all data of the ticks have been dispatched on return. Pull
  /// mode: they are queued for Client::read(). Without lock-step a running world refuses: pause() first.
  Result<void> step(std::uint32_t ticks = 1);
  Result<void> step(std::uint32_t ticks, Seconds patience);
  /// Restarts the run with this seed: at tick 0, with the initial models and their ids. Devices have no data
  /// until new ones arrive.
  /// An error if the server does not keep the initial state, as without lock-step.
  Result<void> reset(std::uint64_t seed);
  /// Spawns a copy of the robot `like` at a pose in the world frame.
  /// Returns its name, chosen by the server if `name` is empty.
  Result<std::string> spawn(std::string_view like, const Pose& pose, std::string_view name = {});
  /// Removes a top-level model with its subtree.
  Result<void> remove(std::string_view name);

  Device& device() { return device_; }

 private:
  explicit Simulation(Device device) : device_(std::move(device)) {}
  Result<std::string> ask_world(std::string_view name, std::string_view property, std::string value,
                                Seconds patience);
  Seconds patience() const;

  Device device_;
};

}  // namespace playhouse::client
