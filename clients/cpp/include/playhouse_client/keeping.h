#pragma once

/// Base of devices whose data are queued until the program takes them.

#include <cstddef>
#include <deque>
#include <vector>

#include "playhouse_client/device.h"

namespace playhouse::client {

class Keeping {
 public:
  /// Capacity of the queue; overflow drops the oldest.
  static constexpr std::size_t kWaiting = 1024;

  Device& device() { return device_; }

 protected:
  explicit Keeping(Device device);

  /// Empties the queue; returns the bodies that were in it, in order.
  std::deque<std::vector<std::byte>> take_kept();

  Device device_;
};

}  // namespace playhouse::client
