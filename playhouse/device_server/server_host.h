#pragma once

/// ServerHost: the environment of drivers whose devices are served
/// by a Server on a network. Derived classes own both, and open worlds.

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <utility>

#include "playhouse/drivers/site.h"
#include "playhouse/net/network.h"
#include "playhouse/server/server.h"

namespace playhouse::device_server {

class ServerHost : public drivers::Host {
 protected:
  /// For destructors: what drivers have begun ends while the server, which sends their answers, and all drivers
  /// are there.
  void end_drivers(drivers::Site& site, std::span<const std::unique_ptr<device::Driver>> drivers) {
    site.data_flow().close();
    the_server().stop_devices();
    for (const auto& driver : drivers) driver->finish();
  }

 private:
  virtual server::Server& the_server() = 0;
  virtual net::Network& the_network() = 0;

  Result<device::DeviceId> add_device(device::Address address, device::Driver& driver) final {
    return the_server().add_device(address, driver);
  }
  void retire_device(device::DeviceId device) final { the_server().retire_device(device); }
  Result<void> hold(device::DeviceId device, device::Driver* holder) final {
    return the_server().hold(device, holder);
  }
  void release(device::DeviceId device, device::Driver* holder) final {
    the_server().release(device, holder);
  }
  std::filesystem::path plugin_program() const final { return has_threads() ? "/proc/self/exe" : ""; }
  void post(std::function<void()> task) final { the_network().post(std::move(task)); }
  net::Network& network() final { return the_network(); }
};

}  // namespace playhouse::device_server
