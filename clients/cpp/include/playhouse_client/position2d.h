#pragma once

/// A mobile base. SI units and radians; x forward, y left, angles counter-clockwise.

#include <optional>

#include "playhouse/wire/generated/position2d.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"

namespace playhouse::client {

class Position2d {
 public:
  /// Odometry: where the base believes to be, how it moves, and whether it is blocked.
  struct State {
    Pose pose;  // from where odometry started
    Velocity velocity;
    bool stalled = false;
    double time = 0;  // the server's, of these data [s]
  };

  static Result<Position2d> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  Position2d(Position2d&&) noexcept = default;
  Position2d& operator=(Position2d&& other) noexcept;
  /// As close().
  ~Position2d();

  /// What the last Client::read() brought; none before the first data.
  std::optional<State> state() const;

  // Commands with a number that is not finite are errors, and nothing is sent.

  /// Forward and to the left (m/s), turning (rad/s), until the next command.
  Result<void> drive(double vx, double va, double vy = 0.0);
  Result<void> stop() { return drive(0.0, 0.0); }

  /// A base that steers like a car: m/s, and rad to the left.
  Result<void> drive_car(double speed, double steering);

  /// To a pose in odometry's frame, with the driver's own planning; speed 0 is the driver's choice.
  Result<void> go_to(const Pose& pose, double speed = 0.0);

  Result<void> set_motor_power(bool on);

  /// Says where the base is from now on; the robot does not move.
  Result<void> set_odometry(const Pose& pose);
  Result<void> reset_odometry();
  Result<Geometry> geometry();

  /// Stops the robot if the last command moved it, and closes the device.
  Result<void> close();

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Position2d(Device device) : device_(std::move(device)) {}

  Device device_;
  bool moving_ = false;
};

}  // namespace playhouse::client
