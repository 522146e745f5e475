#pragma once

/// DeviceTable: maps addresses to drivers and counts opens. Holds the devices that are there
/// now: they may come and go at any time. The first open of a device starts it, the last close stops it. Io
/// thread only.

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

/// As people write it: "6665:laser:0".
std::string describe(Address address);

class DeviceTable {
 public:
  struct Entry {
    Address address;
    Driver* driver = nullptr;  // outlives the device: until retire(), or the table
    std::size_t users = 0;     // opens not yet closed
  };

  DeviceTable() = default;
  ~DeviceTable();
  DeviceTable(const DeviceTable&) = delete;
  DeviceTable& operator=(const DeviceTable&) = delete;

  /// Fails if the address is taken or is the meta device player:0. A port may have more devices than
  /// limits::kDevices: only the list that clients get ends there.
  Result<DeviceId> add(Address address, Driver& driver);
  /// Takes a device out, stops it if it is open, and has its driver forget it: its address is free, its id
  /// means nothing any more, and its driver may go.
  void retire(DeviceId id);

  /// The device at an address; an invalid id if there is none.
  DeviceId find(Address address) const;
  /// What to say of an address where no device is: "no such device, the nearest is 6665:laser:0".
  std::string why_missing(Address address) const;
  /// False for a device that has retired.
  bool has(DeviceId id) const { return entries_.contains(id); }
  /// Asserts that the device is there.
  const Entry& operator[](DeviceId id) const;
  std::size_t size() const { return entries_.size(); }
  /// The devices of one port, in order of creation.
  std::span<const DeviceId> devices_of(std::uint32_t robot) const;

  /// One more user; the first one starts the device and gets the driver's error if it cannot start.
  Result<void> open(DeviceId id);
  /// One user less; the last one stops the device. Asserts that there is one. Does nothing while the table is
  /// destroyed, which stops every device once: drivers that hold others release them then.
  void close(DeviceId id);

 private:
  std::optional<Address> nearest_on(std::uint32_t robot, Address wanted) const;

  std::unordered_map<DeviceId, Entry> entries_;
  std::uint32_t next_row_ = 0;
  bool ending_ = false;
  std::map<Address, DeviceId> by_address_;
  std::map<std::uint32_t, std::vector<DeviceId>> by_robot_;  // in order of creation
};

}  // namespace playhouse::device
