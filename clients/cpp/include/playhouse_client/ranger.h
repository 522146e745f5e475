#pragma once

/// Range sensor: laser scanner or sonar ring. SI units and radians.

#include <optional>

#include "playhouse/wire/generated/ranger.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"
#include "playhouse_client/scan.h"

namespace playhouse::client {

class Ranger {
 public:
  /// Requests configuration and geometry at once. A device that reports
  /// neither is still opened; its scans then have no directions.
  static Result<Ranger> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// Ranges in m, in the order of measurement; empty before the first data.
  std::vector<double> ranges() const;
  std::vector<double> intensities() const;

  /// Ranges with directions: each element's own pose if there is one per range, else spread evenly over the
  /// field of view. None before the first data.
  std::optional<Scan> scan() const;

  const wire::ranger::Config& config() const { return config_; }
  /// Geometry as on the wire, with poses and sizes of all elements.
  const wire::ranger::Geom& geom() const { return geom_; }
  Geometry geometry() const;

  /// Requests a configuration; config() is then what the device accepted.
  Result<void> set_config(const wire::ranger::Config& config);
  Result<void> set_power(bool on);
  Result<void> set_intensities(bool on);

  Device& device() { return device_; }

 private:
  friend class Robot;
  static Result<Ranger> prepare(Device device);
  explicit Ranger(Device device) : device_(std::move(device)) {}

  Device device_;
  wire::ranger::Config config_;
  wire::ranger::Geom geom_;
};

}  // namespace playhouse::client
