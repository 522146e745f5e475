#pragma once

#include <algorithm>

namespace playhouse::behaviour {

/// Proportional control: the speed that reduces `error` at unit gain (1/s), without overshoot within `dt`.
inline double approach(double error, double limit, double dt) {
  return std::clamp(error * std::min(1.0, 1.0 / dt), -limit, limit);
}

}  // namespace playhouse::behaviour
