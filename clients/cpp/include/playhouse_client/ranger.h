#pragma once

/// A device that measures distances: a laser scanner, or a ring of sonars. SI units and radians.

#include <optional>

#include "playhouse/wire/generated/ranger.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"
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
  /// view. None before the first data.
  std::optional<Scan> scan() const;

  const wire::ranger::Config& config() const { return config_; }
  /// The wire's own geometry, with the poses and sizes of the elements.
  const wire::ranger::Geom& geom() const { return geom_; }
  Geometry geometry() const;

  /// Asks for another set-up; config() then shows what the device made of it.
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
