#pragma once

/// Chain of joints that slide or turn, such as an arm. SI units and radians.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "playhouse/wire/generated/actarray.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"

namespace playhouse::client {

/// State of a joint, in m or rad and s. One that neither moves nor is braked or stalled is idle.
struct Joint {
  double position = 0, speed = 0, acceleration = 0;
  std::optional<double> current;  // of its motor [A]; empty if unknown
  bool moving = false, braked = false, stalled = false;
};

struct ActArrayState {
  std::vector<Joint> joints;
  bool motors_on = false;
  double time = 0;  // the server's, of these data [s]
};

struct JointGeometry {
  bool rotary = false;                  // it turns; else it slides
  double length = 0;                    // m, to the next joint
  std::array<double, 3> orientation{};  // at rest, relative to the previous joint: roll, pitch, yaw [rad]
  std::array<double, 3> axis{};         // unit vector
  double lowest = 0, centre = 0, highest = 0, home = 0;  // positions [m or rad]
  double speed = 0;                                      // in position control [m/s or rad/s]
  bool has_brakes = false;
};

struct ActArrayGeometry {
  Pose3d pose;  // of the base of the chain, on the robot
  std::vector<JointGeometry> joints;
};

/// Joints are numbered from 0. A simulated actuator is a chain of one joint, which moves while its device is
/// open.
class ActArray {
 public:
  static constexpr std::int32_t kAll = -1;  // all joints, for home() and set_speed()

  static Result<ActArray> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// The newest state; none before the first data.
  std::optional<ActArrayState> state() const;
  /// Its joints; empty before the first data.
  std::vector<Joint> joints() const;

  // Commands and set_speed(): an error, and nothing is sent, if a number is not finite or exceeds the range
  // of float.

  /// Moves a joint to a position [m or rad].
  Result<void> move_to(std::int32_t joint, double position);
  /// Moves all joints, to one position each.
  Result<void> move_all_to(std::span<const double> positions);
  /// Moves a joint at a speed [m/s or rad/s] until the next command.
  Result<void> move_at(std::int32_t joint, double speed);
  /// Moves all joints, at one speed each.
  Result<void> move_all_at(std::span<const double> speeds);
  /// Moves a joint, or all, to the home position.
  Result<void> home(std::int32_t joint = kAll);

  /// Sets the speed of a joint, or of kAll, in position control.
  Result<void> set_speed(std::int32_t joint, double speed);
  Result<void> set_motor_power(bool on);
  Result<void> set_brakes(bool on);
  Result<ActArrayGeometry> geometry();

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit ActArray(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
