#pragma once

/// Site: what drivers find where they are made: who else is there, how to become known, and the one simulated
/// world that several drivers may share. The program fills it in; drivers know no server and no engine.
/// Threads: everything happens before the io loop runs, and what says so during the run as well.

#include <cstdint>
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
#include "playhouse/device/client.h"
#include "playhouse/device/data_flow.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/simulated/simulation.h"
#include "playhouse/net/network.h"
#include "playhouse/scene/device_address.h"

namespace playhouse::drivers {

/// Makes the program's server and engine do things.
class Surroundings : public device::Opener {
 public:
  /// Makes a device known to clients. Io thread too.
  virtual Result<device::DeviceId> add_device(device::Address address, device::Driver& driver) = 0;
  /// Takes a device out: who has it open or holds it is told. Io thread, not from inside a call of a driver.
  virtual void retire_device(device::DeviceId device) = 0;
  /// Runs the task on the io thread, in the order of the calls and behind what the calling thread published.
  /// Any thread.
  virtual void post(std::function<void()> task) = 0;
  /// For drivers that connect to other machines. Its tasks are those of post().
  virtual net::Network& network() = 0;
  /// Loads a world file into an engine that is ready to run.
  virtual Result<std::unique_ptr<Simulation>> open_world(const std::string& path) = 0;
};

class Site {
 public:
  /// `default_port` stands for the port of addresses that have none.
  Site(Surroundings& surroundings, std::uint16_t default_port)
      : surroundings_(surroundings), default_port_(default_port) {}

  Surroundings& surroundings() { return surroundings_; }
  /// Where drivers publish; the program says where it leads.
  device::DataFlow& data_flow() { return data_flow_; }

  /// The address as clients know it. Fails on an unknown interface and on a device of another host.
  Result<device::Address> resolve(const scene::DeviceAddress& address) const;

  /// As files name it: without the port where it is the default one.
  std::string shown(device::Address address) const;

  /// Makes a device known to clients and to other drivers. Io thread too.
  Result<device::DeviceId> add_device(device::Address address, device::Driver& driver);
  /// A device added by any driver so far; none if there is none.
  std::optional<device::DeviceId> find(device::Address address) const;
  /// Io thread too.
  std::size_t device_count() const { return devices_.size(); }
  /// Every port that has devices.
  std::set<std::uint32_t> ports() const;

  /// The world, once a driver has opened it.
  Simulation* simulation() const { return simulation_.get(); }
  Result<void> open_world(const std::string& path);

  /// Devices retire, and with them those of drivers that require one of them: nothing can come of them any
  /// more. The directory knows none of them when it returns, clients soon after. Tick thread. Devices of
  /// models that leave the world retire without being asked.
  void retire(std::vector<device::Address> devices);
  /// The same from the io thread, soon.
  void retire_later(std::vector<device::Address> devices);

  /// A driver that uses devices of others, whose sections may follow.
  struct User {
    device::Driver* driver = nullptr;
    device::Client* client = nullptr;
    std::vector<device::Address> provided;  // its own devices
    std::vector<device::Address> devices;   // of the client, in its order
    std::string where;                      // "file:line" of the section's `requires`
    /// Runs once the client has its devices, and they theirs.
    std::function<Result<void>()> connected;
  };
  void add_user(User user) { users_.push_back(std::move(user)); }
  /// When every driver of the file is made: gives clients their devices, in the order in which data pass from
  /// driver to driver. Fails on a device that nobody provides and on devices that require each other in a
  /// circle.
  Result<void> finish();

  /// Lines for the person who wrote the file.
  void warn(std::string line) { warnings_.push_back(std::move(line)); }
  std::span<const std::string> warnings() const { return warnings_; }

  /// Models that a driver has already given to an interface: (interface, model row).
  std::set<std::pair<std::uint16_t, std::uint32_t>>& taken_models() { return taken_models_; }

 private:
  Result<void> check_provided(const User& user) const;
  Result<std::vector<const User*>> in_order_of_data() const;
  Error circle_error(std::span<const std::size_t> circle) const;
  void follow(const world::World& world, const world::Change& change);
  void take_out(device::Address address);
  void add_who_requires(std::vector<device::Address>& devices) const;

  Surroundings& surroundings_;
  std::uint16_t default_port_;
  std::unique_ptr<Simulation> simulation_;
  device::DataFlow data_flow_;
  struct Provided {
    device::DeviceId id;
    device::Driver* driver = nullptr;
  };
  std::map<device::Address, Provided> devices_;  // io thread, once it runs
  std::vector<User> users_;
  std::vector<std::string> warnings_;
  std::set<std::pair<std::uint16_t, std::uint32_t>> taken_models_;
};

}  // namespace playhouse::drivers
