#pragma once

/// A finder of markers. SI units and radians.

#include "playhouse/wire/generated/fiducial.h"
#include "playhouse_client/client.h"

namespace playhouse::client {

class Fiducial {
 public:
  static Result<Fiducial> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// What is in sight: numbers, and poses seen from the sensor.
  std::vector<wire::fiducial::Item> markers() const;

  Result<wire::fiducial::Fov> field_of_view();
  Result<void> set_field_of_view(const wire::fiducial::Fov& fov);
  Result<wire::fiducial::Geom> geometry();

  Device& device() { return device_; }

 private:
  explicit Fiducial(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
