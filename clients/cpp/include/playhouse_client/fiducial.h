#pragma once

/// Marker detector. SI units and radians.

#include <cstdint>

#include "playhouse/wire/generated/fiducial.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"

namespace playhouse::client {

/// A visible marker: its id and its pose in the sensor's frame.
struct Marker {
  std::int32_t id = 0;
  Pose3d pose;

  double distance() const;  // m
  double bearing() const;   // rad
};

class Fiducial {
 public:
  static Result<Fiducial> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// The visible markers; empty before the first data.
  std::vector<Marker> markers() const;

  Result<wire::fiducial::Fov> field_of_view();
  Result<void> set_field_of_view(const wire::fiducial::Fov& fov);
  Result<Geometry> geometry();

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Fiducial(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
