#pragma once

/// The system's monotonic clock: the default of whatever can be given another one. Any thread.

#include <chrono>

namespace playhouse {

/// Seconds since an unspecified time; never goes back.
inline double monotonic_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace playhouse
