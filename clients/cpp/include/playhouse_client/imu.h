#pragma once

/// Inertial measurement unit. SI units and radians, in the sensor's frame: x forward, y left, z up.

#include <array>
#include <cstdint>
#include <optional>

#include "playhouse/wire/generated/imu.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"

namespace playhouse::client {

/// Inertial measurement: specific force, (0, 0, 9.81) when level
/// and at rest; angular rates; magnetic field in the server's unit.
struct Inertia {
  std::array<double, 3> acceleration{};  // m/s^2
  std::array<double, 3> turn_rate{};     // rad/s
  std::array<double, 3> field{};
};

/// Roll, pitch and yaw in rad.
struct Attitude {
  double roll = 0, pitch = 0, yaw = 0;
};

class Imu {
 public:
  static Result<Imu> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// Selects the data published to all subscribers: one of wire::imu::kDataState (pose(),
  /// the initial setting), kDataCalib (inertia()), kDataQuat (inertia() and quaternion()),
  /// kDataEuler (inertia() and attitude()) and kDataFullstate (pose() and velocity()).
  Result<void> send(std::uint8_t datatype);

  // From the newest data; none before the first data that contain it.

  /// Estimated pose.
  std::optional<Pose3d> pose() const;
  /// Estimated velocity, in m/s and rad/s.
  std::optional<Pose3d> velocity() const;
  std::optional<Inertia> inertia() const;
  std::optional<Attitude> attitude() const;
  /// Attitude quaternion, real part first.
  std::optional<std::array<double, 4>> quaternion() const;

  /// Makes the current heading 0, or the whole current attitude the reference.
  Result<void> reset_orientation(bool all_axes = false);
  /// Sets the current attitude. An error, and nothing is sent, if a number is not finite.
  Result<void> reset_attitude(const Attitude& attitude);

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Imu(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
