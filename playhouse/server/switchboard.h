#pragma once

/// Switchboard: what every session of a server shares. Io thread only.

#include <cstdint>
#include <functional>

#include "playhouse/device/device_table.h"
#include "playhouse/device/driver.h"
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
  device::DeviceTable devices;
  Fanout fanout;
  Counters counters;
  std::function<double()> clock;  // s; stamps answers
  device::Outlet* outlet;         // where drivers send their answers
};

}  // namespace playhouse::server
