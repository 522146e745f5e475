#pragma once

/// Waits between attempts to reach another server. Values.

#include <algorithm>

namespace playhouse::drivers {

/// After an attempt that came after so long a wait, 0: the first one. [s]
constexpr double next_wait(double last) {
  constexpr double kFirst = 0.5, kLongest = 30;
  return std::clamp(2 * last, kFirst, kLongest);
}

}  // namespace playhouse::drivers
