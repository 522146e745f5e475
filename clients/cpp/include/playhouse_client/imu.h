#pragma once

/// An inertial unit. SI units and radians, along and about its own axes: x forward, y left, z up.

#include <array>
#include <cstdint>
#include <optional>

#include "playhouse/wire/generated/imu.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"

namespace playhouse::client {

/// What an inertial unit feels: acceleration with gravity, so that (0, 0, 9.81) is at rest and level; turn
/// rates; the direction of the magnetic field, in a unit of the server's.
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

  /// Which of its data it sends from now on, to all who have the device open: one of wire::imu::kDataState
  /// (pose()), kDataCalib (inertia()), kDataQuat (inertia() and quaternion()), kDataEuler (inertia() and
  /// attitude()) and kDataFullstate (pose() and velocity()). A server sends kDataState at first.
  Result<void> send(std::uint8_t datatype);

  // Of the newest data; none before the first that have it.

  /// Where it believes to be.
  std::optional<Pose3d> pose() const;
  /// How it believes to move, in m/s and rad/s.
  std::optional<Pose3d> velocity() const;
  std::optional<Inertia> inertia() const;
  std::optional<Attitude> attitude() const;
  /// Its attitude, the real part first.
  std::optional<std::array<double, 4>> quaternion() const;

  /// Makes the present heading 0, or the whole present attitude the reference.
  Result<void> reset_orientation(bool all_axes = false);
  /// What its attitude is now. An error, and nothing is sent, with a number that is not finite.
  Result<void> reset_attitude(const Attitude& attitude);

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Imu(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
