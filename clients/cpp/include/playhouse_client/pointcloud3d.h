#pragma once

/// Point clouds, as of a multi-ring lidar.

#include <array>
#include <cstdint>
#include <vector>

#include "playhouse/wire/generated/pointcloud3d.h"
#include "playhouse_client/client.h"

namespace playhouse::client {

/// Position in m, in the sensor's frame; red, green, blue and alpha, 0 to 255.
struct CloudPoint {
  double x = 0, y = 0, z = 0;
  std::array<std::uint8_t, 4> color{};
};

class PointCloud3d {
 public:
  static Result<PointCloud3d> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// The newest cloud; empty before the first data.
  std::vector<CloudPoint> points() const;

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit PointCloud3d(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
