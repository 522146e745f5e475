#pragma once

/// Points in space, as of a lidar with several rings.

#include <array>
#include <cstdint>
#include <vector>

#include "playhouse/wire/generated/pointcloud3d.h"
#include "playhouse_client/client.h"

namespace playhouse::client {

/// In m, in the frame of the sensor; red, green, blue and alpha from 0 to 255.
struct CloudPoint {
  double x = 0, y = 0, z = 0;
  std::array<std::uint8_t, 4> color{};
};

class PointCloud3d {
 public:
  static Result<PointCloud3d> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// What the last Client::read() brought; empty before the first data.
  std::vector<CloudPoint> points() const;

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit PointCloud3d(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
