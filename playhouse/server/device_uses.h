#pragma once

/// DeviceUses: for each device, the parties to notify when it
/// retires: sessions that have it open, pending requests, drivers
/// that hold it. No entries for unused devices. Io thread only.

#include <cstddef>
#include <cstdint>
#include <set>
#include <unordered_map>
#include <vector>

#include "playhouse/device/address.h"
#include "playhouse/device/driver.h"

namespace playhouse::server {

class DeviceUses {
 public:
  struct DeviceUse {
    std::set<std::uint32_t> sessions;      // session serials
    std::set<std::uint64_t> tickets;       // of pending requests, in order for each session
    std::vector<device::Driver*> holders;  // once per hold
  };

  void open(device::DeviceId device, std::uint32_t session) { uses_[device].sessions.insert(session); }
  void close(device::DeviceId device, std::uint32_t session);
  void ask(device::DeviceId device, std::uint64_t ticket) { uses_[device].tickets.insert(ticket); }
  void answer(device::DeviceId device, std::uint64_t ticket);
  void hold(device::DeviceId device, device::Driver& holder) { uses_[device].holders.push_back(&holder); }
  /// Ends one hold; no effect if there is none.
  void release(device::DeviceId device, device::Driver& holder);

  /// Removes and returns the entry of a device.
  DeviceUse take(device::DeviceId device);
  /// Number of devices in use.
  std::size_t size() const { return uses_.size(); }

 private:
  using Uses = std::unordered_map<device::DeviceId, DeviceUse>;
  void drop_if_unused(Uses::iterator place);

  Uses uses_;
};

}  // namespace playhouse::server
