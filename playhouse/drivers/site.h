#pragma once

/// Site: the environment in which drivers are made: other drivers' devices, registration, and the one
/// simulated world that several drivers may share, if there is one. Filled in by the program; drivers know no server
/// and no engine. Threads: everything happens before the io loop runs, unless stated otherwise.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/config/device_address.h"
#include "playhouse/device/client.h"
#include "playhouse/device/data_flow.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/always_on.h"
#include "playhouse/drivers/site_world.h"
#include "playhouse/libraries/libraries.h"
#include "playhouse/net/network.h"

namespace playhouse::drivers {

class Site;

/// Interface to the program's server and engine.
class Host : public device::Opener {
 public:
  /// Registers a device. Io thread too.
  virtual Result<device::DeviceId> add_device(device::Address address, device::Driver& driver) = 0;
  /// Retires a device: clients that have it open are notified. Io thread, not from inside a driver call.
  virtual void retire_device(device::DeviceId device) = 0;
  /// Opens a further port for clients. Tick thread, or before the run; the tick thread waits for the io
  /// thread.
  virtual Result<void> open_port(std::uint32_t port) {
    return Error{std::to_string(port), "this program opens no further ports"};
  }
  /// Runs the task on the io thread, in the order of calls
  /// and after what the calling thread published. Any thread.
  virtual void post(std::function<void()> task) = 0;
  /// False: drivers compute on the threads that call them, as in a simulation of the whole program. Before
  /// the run.
  virtual bool has_threads() const { return true; }
  /// For drivers that connect to other machines. Same thread as tasks of post().
  virtual net::Network& network() = 0;
  /// Where plug-ins may come from.
  virtual libraries::Libraries libraries() const { return {}; }
  /// The program that calls plug-ins in processes of their own (isolated/isolated_main.h); empty: none may be started.
  virtual std::filesystem::path plugin_program() const { return {}; }
  /// Loads a world file into a new engine, for a site.
  virtual Result<std::unique_ptr<SiteWorld>> open_world(const std::string& path, Site& site);
};

class Site {
 public:
  /// `default_port` applies to addresses without a port.
  Site(Host& surroundings, std::uint16_t default_port)
      : surroundings_(surroundings), default_port_(default_port) {}

  Host& surroundings() { return surroundings_; }
  /// Where drivers publish; connected by the program.
  device::DataFlow& data_flow() { return data_flow_; }

  /// The full address. Fails on an unknown interface and on a device of another host.
  Result<device::Address> resolve(const config::DeviceAddress& address) const;

  /// As in files: without the port if that is the default one.
  std::string shown(device::Address address) const;

  /// Registers a device with the server and for other drivers. Io thread too.
  Result<device::DeviceId> add_device(device::Address address, device::Driver& driver);
  /// A device registered by any driver so far; none if there is none.
  std::optional<device::DeviceId> find(device::Address address) const;
  /// Io thread too.
  std::size_t device_count() const { return devices_.size(); }
  /// All ports with devices, except those of other servers.
  std::set<std::uint32_t> ports() const;

  /// The world, once a driver has opened it; null before.
  SiteWorld* world() const { return world_.get(); }
  Result<void> open_world(const std::string& path);
  /// Simulated time, or that of the clock, since 1970, without a world. Any thread. [s]
  double time() const;

  /// Retires devices, and recursively those of drivers that require them, since
  /// they have lost their input. Removed from the directory on return, from clients
  /// soon after. Tick thread. Devices of removed models retire automatically.
  void retire(std::vector<device::Address> devices);
  /// The same from the io thread, asynchronously.
  void retire_later(std::vector<device::Address> devices);

  /// A driver that uses devices of other drivers, whose sections may come later.
  struct User {
    device::Driver* driver = nullptr;
    device::DeviceClient* client = nullptr;
    std::vector<device::Address> provided;  // its own devices
    std::vector<device::Address> devices;   // of the client, in its order
    std::string where;                      // "file:line" of the section's `requires`
    /// Called once the client and all drivers that it uses have their devices.
    std::function<Result<void>()> connected;
  };
  void add_user(User user) { users_.push_back(std::move(user)); }
  /// Devices that drivers require of a port on which this file provides none: those of another server on
  /// this machine. From now on that is where the port is.
  std::set<device::Address> take_remote_devices();
  /// Opens these devices of a driver for good, those that are not ready once they are (AlwaysOn). Once all drivers
  /// of the file exist. Fails if one that is ready cannot start.
  Result<void> keep_open(device::Driver& driver, std::vector<device::DeviceId> devices, std::string name);
  /// Called when all drivers of the file exist: connects clients
  /// to their devices, in topological order of data flow. Fails
  /// on a device without a provider and on cyclic requirements.
  Result<void> finish();

  /// Warnings for the author of the file.
  void warn(std::string line) { warnings_.push_back(std::move(line)); }
  std::span<const std::string> warnings() const { return warnings_; }

 private:
  Result<void> check_provided(const User& user) const;
  Result<std::vector<const User*>> in_order_of_data() const;
  Error circle_error(std::span<const std::size_t> circle) const;
  void take_out(device::Address address);
  void add_who_requires(std::vector<device::Address>& devices) const;

  Host& surroundings_;
  std::uint16_t default_port_;
  device::DataFlow data_flow_;
  std::unique_ptr<SiteWorld> world_;
  struct ProvidedDevice {
    device::DeviceId id;
    device::Driver* driver = nullptr;
  };
  std::map<device::Address, ProvidedDevice> devices_;  // io thread, once it runs
  std::set<std::uint32_t> remote_ports_;
  std::vector<User> users_;
  std::vector<std::string> warnings_;
  std::vector<std::unique_ptr<AlwaysOn>> always_on_;
};

}  // namespace playhouse::drivers
