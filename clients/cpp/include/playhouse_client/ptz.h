#pragma once

/// A mount that turns and zooms a camera. SI units and radians.

#include <optional>

#include "playhouse/wire/generated/ptz.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"

namespace playhouse::client {

/// Where a camera looks: to the left, up, and its horizontal field of view, in rad; how fast it turns, in
/// rad/s.
struct View {
  double pan = 0, tilt = 0, zoom = 0;
  double pan_speed = 0, tilt_speed = 0;
  friend bool operator==(const View&, const View&) = default;
};

class Ptz {
 public:
  static Result<Ptz> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// Where it looks now; none before the first data.
  std::optional<View> view() const;

  // Commands with a number that is not finite, or more than a float holds, are errors, and nothing is sent.

  /// Turns there (rad), as position control has it; a zoom of 0 leaves the field of view as it is.
  Result<void> look(double pan, double tilt = 0.0, double zoom = 0.0);
  /// Turns at these speeds (rad/s); wants set_velocity_control(true) before.
  Result<void> turn(double pan_speed, double tilt_speed = 0.0);

  /// Whether commands mean velocities from now on, or places.
  Result<void> set_velocity_control(bool on);
  Result<Geometry> geometry();

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Ptz(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
