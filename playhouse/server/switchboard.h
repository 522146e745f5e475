#pragma once

/// Switchboard: shared state of a server's sessions. Io thread only.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/device/caller.h"
#include "playhouse/device/device_table.h"
#include "playhouse/device/driver.h"
#include "playhouse/device/turns.h"
#include "playhouse/server/device_uses.h"
#include "playhouse/server/fanout.h"

namespace playhouse::server {

/// Totals over all sessions.
struct Counters {
  std::uint64_t messages_received = 0;
  std::uint64_t messages_sent = 0;
  std::uint64_t bytes_sent = 0;
  std::uint64_t data_dropped = 0;
  std::uint64_t commands_dropped = 0;
  std::uint64_t requests_refused = 0;
};

struct Switchboard {
  DeviceUses uses;  // outlives the devices: drivers release their holds when stopped
  device::DeviceTable devices;
  FrameBytes frame_bytes = std::make_shared<std::size_t>(0);  // limits::kOutputBytes
  Fanout fanout{frame_bytes};
  Counters counters;
  std::string group_place;        // where data go by multicast, MulticastGroup::place(); empty: nowhere
  std::function<double()> clock;  // s; timestamps of replies
  device::Outlet* outlet;         // receives drivers' replies
  const device::Turns* turns = nullptr;  // of clients; null: no ordering
  /// The rights of a client with this token ("*": without one) from this peer, "address:port"; none:
  /// the token is wrong. Empty: every client has all rights.
  std::function<std::optional<device::Rights>(const std::string& token, const std::string& peer)> admit;
  bool run_is_over = false;             // nobody carries out requests any more
  std::atomic<bool> held_back = false;  // a session is waiting for its turn
  std::deque<std::uint32_t> due;  // serials of the sessions with work, served in turn, longest waiting first
  /// Cached bodies of device lists, by port; cleared when a device is added or retires.
  std::map<std::uint32_t, std::vector<std::byte>> device_lists;

  std::size_t input_bytes = 0;  // memory held by all long messages that are incomplete (limits::kInputBytes)
  std::uint64_t input_turns = 0;  // counter for Session::input_turn()
};

}  // namespace playhouse::server
