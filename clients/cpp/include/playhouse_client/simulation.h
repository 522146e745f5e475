#pragma once

/// The simulator itself: poses of models by their full names, each in its parent's frame, which is the world
/// for a model that nothing carries. SI units and radians.

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

  /// An error, which names it, if there is no such model.
  Result<Pose> pose(std::string_view model);
  /// An error also if a number of the pose is not finite.
  Result<void> set_pose(std::string_view model, const Pose& pose);
  Result<Pose3d> pose3d(std::string_view model);
  Result<void> set_pose3d(std::string_view model, const Pose3d& pose);

  /// Stops the clock, or lets it go on.
  Result<void> pause();
  /// Everything back to where the world file has it, while time goes on.
  Result<void> reset();
  /// Has the program write the world as it stands into the file that `playhouse run --save-world` names;
  /// without that option nothing happens.
  Result<void> save();

  /// This client is one of those that a world in lock-step waits for, by this name, until its connection
  /// ends. Open devices first. An error says why it may not.
  Result<void> join(std::string_view name);
  /// Lets the world go on by so many ticks and waits until they are done, in lock-step for as long as the
  /// others take. In push mode all data of the ticks have been handed to the devices then; in pull mode they
  /// wait for Client::read(). Without lock-step the world is paused afterwards.
  Result<void> step(std::uint32_t ticks = 1);
  Result<void> step(std::uint32_t ticks, Seconds patience);
  /// The run begins again with this seed: at tick 0, with the models of then and their ids. An error where
  /// the server does not keep the start, as without lock-step.
  Result<void> reset(std::uint64_t seed);
  /// Adds a robot like the model of that name, at a place in the world; gives its name, which the server
  /// chooses if it is given none.
  Result<std::string> spawn(std::string_view like, const Pose& pose, std::string_view name = {});
  /// Takes a model at the top out of the world, with what it carries.
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
