#pragma once

/// AlwaysOn: keeps the devices of a section with `alwayson` open for the program's lifetime. Those that need a
/// device of another server start once that one can be opened.

#include <memory>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/device/driver.h"
#include "playhouse/net/network.h"

namespace playhouse::drivers {

class Host;

class AlwaysOn {
 public:
  /// `name`: of the section, for the log. References must outlive it.
  AlwaysOn(Host& surroundings, device::Driver& driver, std::vector<device::DeviceId> devices,
           std::string name);

  /// Opens the devices that are ready, and has the others wait. Fails if one that is ready cannot start. Call
  /// once, before the io thread runs.
  Result<void> begin();

 private:
  void prepare_all();
  void prepared(device::DeviceId device, const Result<void>& outcome);
  void wait(const std::string& why);

  Host& surroundings_;
  device::Driver& driver_;
  std::vector<device::DeviceId> devices_;  // that wait
  const std::string name_;
  std::string told_;                          // what they wait for, in the log
  double wait_ = 0;                           // s until the next attempt
  std::unique_ptr<net::Timer> next_attempt_;  // last member
};

}  // namespace playhouse::drivers
