#pragma once

/// Orientation in space.

namespace playhouse::client {

/// Roll, pitch and yaw in rad.
struct Attitude {
  double roll = 0, pitch = 0, yaw = 0;
};

}  // namespace playhouse::client
