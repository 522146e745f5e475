#pragma once

/// Laser scanner; its data include the beam directions. SI units and radians.

#include <optional>

#include "playhouse/wire/generated/laser.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"
#include "playhouse_client/scan.h"

namespace playhouse::client {

class Laser {
 public:
  static Result<Laser> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// The newest scan; none before the first data.
  std::optional<Scan> scan() const;
  /// One intensity per range, in the device's own unit; empty if it measures none.
  std::vector<std::uint8_t> intensities() const;

  Result<wire::laser::Config> config();
  Result<void> set_config(const wire::laser::Config& config);
  Result<Geometry> geometry();

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Laser(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
