#pragma once

/// DeviceTable: the current devices: maps addresses to drivers and
/// counts opens. Devices may be added and retired at any time. The
/// first open starts a device, the last close stops it. Io thread only.

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/device/address.h"
#include "playhouse/device/driver.h"

namespace playhouse::device {

/// Text form: "6665:laser:0".
std::string describe(Address address);
/// The same without the port: "laser:0".
std::string describe_on_port(Address address);

class DeviceTable {
 public:
  struct ServedDevice {
    Address address;
    Driver* driver = nullptr;  // must outlive the device: until retire(), or the table
    std::size_t users = 0;     // number of opens
  };

  DeviceTable() = default;
  ~DeviceTable() { end(); }
  /// Stops all devices that are open, for good: nothing opens or closes them afterwards.
  void end();
  DeviceTable(const DeviceTable&) = delete;
  DeviceTable& operator=(const DeviceTable&) = delete;

  /// Fails if the address is taken or is the meta device player:0. A port may have
  /// more than limits::kDevices devices, but lists for clients are truncated there.
  Result<DeviceId> add(Address address, Driver& driver);
  /// Removes a device, stops it if open, and calls its driver's forget(): its
  /// address is free, its id is invalid, and its driver may be destroyed.
  void retire(DeviceId id);

  /// The device at an address; an invalid id if there is none.
  DeviceId find(Address address) const;
  /// Error message for an empty address: "no such device, the nearest is 6665:laser:0".
  std::string why_missing(Address address) const;
  /// False for a retired device.
  bool has(DeviceId id) const { return entries_.contains(id); }
  /// Asserts that the device exists.
  const ServedDevice& operator[](DeviceId id) const;
  std::size_t size() const { return entries_.size(); }
  const std::map<Address, DeviceId>& by_address() const { return by_address_; }
  /// The devices of one port, in order of registration.
  std::span<const DeviceId> devices_of(std::uint32_t robot) const;

  /// Adds a user; the first one starts the device. Fails if it cannot start.
  Result<void> open(DeviceId id);
  /// Removes a user; the last one stops the device. Asserts that there is one. No effect in the
  /// table's destructor, which stops every device once: drivers release the devices they hold then.
  void close(DeviceId id);

 private:
  std::optional<Address> nearest_on(std::uint32_t robot, Address wanted) const;

  std::unordered_map<DeviceId, ServedDevice> entries_;
  std::uint32_t next_row_ = 0;
  bool ending_ = false;
  std::map<Address, DeviceId> by_address_;
  std::map<std::uint32_t, std::vector<DeviceId>> by_robot_;  // in order of registration
};

}  // namespace playhouse::device
