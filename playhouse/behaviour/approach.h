#pragma once

#include <algorithm>

namespace playhouse::behaviour {

/// The speed that removes `error` without overshooting within one tick of `dt`: so much per second.
inline double approach(double error, double limit, double dt) {
  return std::clamp(error * std::min(1.0, 1.0 / dt), -limit, limit);
}

}  // namespace playhouse::behaviour
