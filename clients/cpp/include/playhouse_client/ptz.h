#pragma once

/// Pan-tilt-zoom unit of a camera. SI units and radians.

#include <optional>

#include "playhouse/wire/generated/ptz.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"

namespace playhouse::client {

/// Pan (left), tilt (up) and horizontal field of view (zoom), in rad; angular speeds in
/// rad/s.
struct View {
  double pan = 0, tilt = 0, zoom = 0;
  double pan_speed = 0, tilt_speed = 0;
  friend bool operator==(const View&, const View&) = default;
};

class Ptz {
 public:
  static Result<Ptz> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// The current view; none before the first data.
  std::optional<View> view() const;

  // Commands: an error, and nothing is sent, if a number is not finite or exceeds the range of float.

  /// Position control: pan and tilt in rad; zoom 0 leaves the field of view unchanged.
  Result<void> look(double pan, double tilt = 0.0, double zoom = 0.0);
  /// Velocity control (rad/s); needs set_velocity_control(true) first.
  Result<void> turn(double pan_speed, double tilt_speed = 0.0);

  /// Selects velocity or position control for the commands that follow.
  Result<void> set_velocity_control(bool on);
  Result<Geometry> geometry();

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Ptz(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
