#pragma once

/// The system's clocks: the defaults of whatever can be given another one. Any thread.

#include <chrono>

namespace playhouse {

/// Seconds since an unspecified time; never goes back.
inline double monotonic_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Unix time in seconds, of the system's clock, which may be set. Any thread.
inline double unix_seconds() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

}  // namespace playhouse
