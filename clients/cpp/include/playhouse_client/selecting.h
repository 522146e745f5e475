#pragma once

/// Base of devices that send one of several data messages.

#include <cstdint>
#include <utility>

#include "playhouse_client/device.h"

namespace playhouse::client {

class Selecting {
 public:
  /// Selects the data published to all subscribers: one of wire::imu::kDataState (pose(),
  /// the initial setting), kDataCalib (inertia()), kDataQuat (inertia() and quaternion()),
  /// kDataEuler (inertia() and attitude()) and kDataFullstate (pose() and velocity()).
  Result<void> send(std::uint8_t datatype);

  Device& device() { return device_; }

 protected:
  explicit Selecting(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
