#pragma once

/// Switchboard: what every session of a server shares. Io thread only.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "playhouse/device/device_table.h"
#include "playhouse/device/driver.h"
#include "playhouse/device/turns.h"
#include "playhouse/server/device_uses.h"
#include "playhouse/server/fanout.h"

namespace playhouse::server {

/// Sums over all sessions since the start.
struct Counters {
  std::uint64_t messages_received = 0;
  std::uint64_t messages_sent = 0;
  std::uint64_t bytes_sent = 0;
  std::uint64_t data_dropped = 0;
  std::uint64_t commands_dropped = 0;
  std::uint64_t requests_refused = 0;
};

struct Switchboard {
  DeviceUses uses;  // outlives the devices: drivers that are stopped release what they hold
  device::DeviceTable devices;
  FrameBytes frame_bytes = std::make_shared<std::size_t>(0);  // limits::kOutputBytes
  Fanout fanout{frame_bytes};
  Counters counters;
  std::function<double()> clock;         // s; stamps answers
  device::Outlet* outlet;                // where drivers send their answers
  const device::Turns* turns = nullptr;  // of clients; none: everybody may act at any time
  std::atomic<bool> held_back = false;   // somebody waits for its turn
  std::deque<std::uint32_t> due;  // serials of the sessions with something to do, the longest waiting first
  /// Bodies of the answers to "which devices are there", by port; forgotten when a device comes or goes.
  std::map<std::uint32_t, std::vector<std::byte>> device_lists;

  std::size_t input_bytes = 0;  // of memory for long messages that have not come whole (limits::kInputBytes)
  std::uint64_t input_turns = 0;  // numbers the moments at which such a message began
};

}  // namespace playhouse::server
