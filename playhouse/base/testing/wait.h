#pragma once

/// How tests in C++ wait for other threads and processes: for what they need, never for a time. The one
/// place of theirs that sleeps and reads a clock (tools/waits.py).

#include <chrono>
#include <thread>

namespace playhouse {

/// From now on; a wait that lasts until then has failed. Generous, for slow machines with sanitizers.
inline std::chrono::steady_clock::time_point patience() {
  return std::chrono::steady_clock::now() + std::chrono::minutes(1);
}

/// Looks until `done` holds; false if it never does.
template <typename Condition>
bool wait_until(const Condition& done) {
  const auto end = patience();
  while (!done()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

}  // namespace playhouse
