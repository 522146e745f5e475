#pragma once

/// Switches that feel a touch. SI units and radians.

#include "playhouse/wire/generated/bumper.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"

namespace playhouse::client {

/// Where a switch is touched.
struct Face {
  Pose3d pose;        // of its middle, on the robot; it looks along yaw
  double length = 0;  // m, across
  double radius = 0;  // m, of its bend; 0 if it is straight
};

class Bumper {
 public:
  static Result<Bumper> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// One per switch, in the order of faces(); empty before the first data.
  std::vector<bool> pressed() const;
  /// Where the switches sit on the robot.
  Result<std::vector<Face>> faces();

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Bumper(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
