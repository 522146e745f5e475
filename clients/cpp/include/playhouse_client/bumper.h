#pragma once

/// Contact switches. SI units and radians.

#include "playhouse/wire/generated/bumper.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"

namespace playhouse::client {

/// Geometry of one switch.
struct Face {
  Pose3d pose;        // of its middle, on the robot; it looks along yaw
  double length = 0;  // m, across
  double radius = 0;  // m, of its bend; 0 if it is straight
};

class Bumper {
 public:
  static Result<Bumper> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// One state per switch, in the order of faces(); empty before the first data.
  std::vector<bool> pressed() const;
  /// Poses of the switches in the robot's frame.
  Result<std::vector<Face>> faces();

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Bumper(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
