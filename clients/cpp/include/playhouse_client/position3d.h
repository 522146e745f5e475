#pragma once

/// Mobile base in space. SI units and radians; x forward, y left, z up.

#include <optional>

#include "playhouse/wire/generated/position3d.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"

namespace playhouse::client {

class Position3d {
 public:
  /// Estimated pose and velocity, and whether the base is stalled.
  struct State {
    Pose3d pose;
    Pose3d velocity;  // m/s and rad/s along and about its own axes
    bool stalled = false;
    double time = 0;  // the server's, of these data [s]
  };

  static Result<Position3d> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  Position3d(Position3d&&) noexcept = default;
  Position3d& operator=(Position3d&& other) noexcept;
  /// As close().
  ~Position3d();

  /// The newest state; none before the first data.
  std::optional<State> state() const;

  // Commands: an error, and nothing is sent, if a number is not finite.

  /// Velocity until the next command: forward, left and up (m/s), turn rate (rad/s).
  Result<void> drive(double vx, double va, double vy = 0.0, double vz = 0.0);
  Result<void> stop() { return drive(0.0, 0.0); }

  /// Goal pose in the frame of State::pose, planned by the driver.
  Result<void> go_to(const Pose3d& pose);

  Result<void> set_motor_power(bool on);

  /// Sets State::pose; the robot does not move.
  Result<void> set_odometry(const Pose3d& pose);
  Result<void> reset_odometry();
  Result<Geometry> geometry();

  /// Stops the robot if the last command was a motion, and closes the device.
  Result<void> close();

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Position3d(Device device) : device_(std::move(device)) {}

  Device device_;
  bool moving_ = false;
};

}  // namespace playhouse::client
