#pragma once

/// Satellite navigation receiver.

#include <cstdint>
#include <optional>

#include "playhouse/wire/generated/gps.h"
#include "playhouse_client/client.h"

namespace playhouse::client {

/// Measured position (WGS84). `quality` is 0 without a fix; all other members are then
/// meaningless.
struct Fix {
  double latitude = 0, longitude = 0;  // degrees
  double altitude = 0;                 // m above the ellipsoid
  double easting = 0, northing = 0;    // m, of UTM
  double speed = 0, course = 0;        // m/s; rad, clockwise from north
  std::uint32_t quality = 0, satellites = 0;
  double horizontal_error = 0, vertical_error = 0;  // m, expected
  double time = 0;                                  // the server's, of these data [s]
};

class Gps {
 public:
  static Result<Gps> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// The newest fix received; none before the first data.
  std::optional<Fix> fix() const;

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Gps(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
