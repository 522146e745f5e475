#pragma once

#include <algorithm>

namespace playhouse::behaviour {

/// Proportional control: the speed that reduces `error` at unit gain (1/s), without overshoot within `dt`.
inline double approach(double error, double limit, double dt) {
  return std::clamp(error * std::min(1.0, 1.0 / dt), -limit, limit);
}

/// A wanted velocity of a body that speeds up by at most `acceleration`, 0: by any. It brakes as it is told, so that it
/// stops where it is to.
inline double sped_up(double before, double wanted, double acceleration, double dt) {
  if (acceleration == 0) return wanted;
  const double from = before * wanted > 0 ? before : 0;  // it stops first if it turns round
  return wanted > 0 ? std::min(wanted, from + acceleration * dt) : std::max(wanted, from - acceleration * dt);
}

}  // namespace playhouse::behaviour
