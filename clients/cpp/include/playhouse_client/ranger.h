#pragma once

/// A device that measures distances: a laser scanner, or a ring of sonars. SI units and radians.

#include "playhouse/wire/generated/ranger.h"
#include "playhouse_client/client.h"
#include "playhouse_client/scan.h"

namespace playhouse::client {

class Ranger {
 public:
  /// Asks for set-up and geometry at once; a device that tells neither is still opened, and its scans point
  /// nowhere.
  static Result<Ranger> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// In m, in the order of measurement; empty before the first data.
  std::vector<double> ranges() const;
  std::vector<double> intensities() const;

  /// Ranges with directions: each element's own if there is one per range, else spread over the field of
  /// view.
  Scan scan() const;

  const wire::ranger::Config& config() const { return config_; }
  const wire::ranger::Geom& geometry() const { return geometry_; }

  /// Asks for another set-up; config() then shows what the device made of it.
  Result<void> set_config(const wire::ranger::Config& config);
  Result<void> set_power(bool on);
  Result<void> set_intensities(bool on);

  Device& device() { return device_; }

 private:
  explicit Ranger(Device device) : device_(std::move(device)) {}

  Device device_;
  wire::ranger::Config config_;
  wire::ranger::Geom geometry_;
};

}  // namespace playhouse::client
