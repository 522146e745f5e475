#pragma once

/// A robot's wheels as interface position2d: velocities, goals and odometry (docs/drivers.md).

#include "playhouse/drivers/generated/device_makers.h"

namespace playhouse::drivers {

/// Drives at a velocity, if the robot is still there. Finite. [m/s, rad/s, in the robot's frame]
Change velocity_command(world::ModelId robot, const geom::Twist& velocity);
/// Goes to a pose in the frame of its odometry. [m, rad]
Change goal_command(world::ModelId robot, const geom::Pose& goal_O);
/// What its odometry shall say now; false if it is gone or that is no place. [m, rad]
bool set_odometry_of(world::World& world, world::ModelId robot, const geom::Pose& X_OM);
/// False if it is gone.
bool set_motor(world::World& world, world::ModelId robot, bool on);

class Position2d final : public SimulatedDevice {
 public:
  /// `model` is of kind kPosition.
  Position2d(Simulation& simulation, world::ModelRow model);

  world::ModelId robot() const override { return model(); }
  std::span<const Served> served() const override;
  device::Taken command(const device::Message& message) override;
  void request(const device::Message& message, device::Replier replier) override;
  void emit(const world::World& world, std::vector<device::Publication>& out) override;
  void closed(world::World& world, world::ModelRow model) override;

 private:
  /// What a command means; empty if it makes no sense.
  Change meaning(const device::Message& message) const;
  void set_odometry(const geom::Pose& X_OM, device::Replier replier);

  std::uint64_t update_ticks_;
  Bytes geometry_;
};

}  // namespace playhouse::drivers
