#pragma once

/// Mobile base in the plane. SI units and radians; x forward, y left, angles counter-clockwise.

#include <optional>

#include "playhouse/wire/generated/position2d.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"

namespace playhouse::client {

class Position2d {
 public:
  /// Odometry: estimated pose, velocity, and whether the base is stalled.
  struct State {
    Pose pose;  // in the odometry frame
    Velocity velocity;
    bool stalled = false;
    double time = 0;  // the server's, of these data [s]
  };

  static Result<Position2d> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  Position2d(Position2d&&) noexcept = default;
  Position2d& operator=(Position2d&& other) noexcept;
  /// As close().
  ~Position2d();

  /// The newest state; none before the first data.
  std::optional<State> state() const;

  // Commands: an error, and nothing is sent, if a number is not finite.

  /// Velocity until the next command: forward and left (m/s), turn rate (rad/s).
  Result<void> drive(double vx, double va, double vy = 0.0);
  Result<void> stop() { return drive(0.0, 0.0); }

  /// Command of a car-like base: speed in m/s, steering angle in rad, positive left.
  Result<void> drive_car(double speed, double steering);

  /// Goal pose in the odometry frame, planned by the driver; speed 0: the driver's default.
  Result<void> go_to(const Pose& pose, double speed = 0.0);

  /// Requests why the driver (nd, vfh) does not drive to the goal of the last go_to(), as its log says; empty
  /// if it does, has arrived, or is a driver that gives no reasons.
  Result<std::string> why_refused();

  Result<void> set_motor_power(bool on);

  /// Sets the odometry pose; the robot does not move.
  Result<void> set_odometry(const Pose& pose);
  Result<void> reset_odometry();
  Result<Geometry> geometry();

  /// Stops the robot if the last command was a motion, and closes the device.
  Result<void> close();

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Position2d(Device device) : device_(std::move(device)) {}

  Device device_;
  bool moving_ = false;
};

}  // namespace playhouse::client
