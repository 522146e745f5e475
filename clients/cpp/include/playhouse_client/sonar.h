#pragma once

/// Sonar ring. SI units and radians.

#include "playhouse/wire/generated/sonar.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"

namespace playhouse::client {

class Sonar {
 public:
  static Result<Sonar> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// One range per sonar [m], in the order of poses(); empty before the first data.
  std::vector<double> ranges() const;
  /// Poses of the sonars in the robot's frame.
  Result<std::vector<Pose3d>> poses();
  Result<void> set_power(bool on);

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Sonar(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
