#pragma once

/// Site: what drivers find where they are made: who else is there, how to become known, and the one simulated
/// world that several drivers may share. The program fills it in; drivers know no server and no engine.
/// Everything happens before the io loop runs, but hold() and release(), which are for the io thread too.

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
#include "playhouse/device/driver.h"
#include "playhouse/drivers/simulated/simulation.h"
#include "playhouse/drivers/tap.h"
#include "playhouse/scene/device_address.h"

namespace playhouse::drivers {

/// Makes the program's server and engine do things.
class Surroundings {
 public:
  virtual ~Surroundings() = default;
  /// Makes a device known to clients.
  virtual Result<device::DeviceId> add_device(device::Address address, device::Driver& driver) = 0;
  /// Opens a device on behalf of a driver, and undoes it.
  virtual Result<void> hold(device::DeviceId device) = 0;
  virtual void release(device::DeviceId device) = 0;
  /// Loads a world file into an engine that is ready to run.
  virtual Result<std::unique_ptr<Simulation>> open_world(const std::string& path) = 0;
};

class Site {
 public:
  /// `default_port` stands for the port of addresses that have none.
  Site(Surroundings& surroundings, std::uint16_t default_port)
      : surroundings_(surroundings), default_port_(default_port) {}

  Surroundings& surroundings() { return surroundings_; }
  /// What drivers read of each other's data; the program lets every publication pass through it.
  Tap& tap() { return tap_; }

  /// The address as clients know it. Fails on an unknown interface and on a device of another host.
  Result<device::Address> resolve(const scene::DeviceAddress& address) const;

  /// Makes a device known to clients and to other drivers.
  Result<device::DeviceId> add_device(device::Address address, device::Driver& driver);
  struct Neighbour {
    device::DeviceId id;
    device::Driver* driver = nullptr;
  };
  /// A device added by any driver so far; none if there is none.
  std::optional<Neighbour> find(device::Address address) const;
  std::size_t device_count() const { return devices_.size(); }
  /// Every port that has devices.
  std::set<std::uint32_t> ports() const;

  /// The world, once a driver has opened it.
  Simulation* simulation() { return simulation_.get(); }
  Result<void> open_world(const std::string& path);

  /// `task` runs when every driver of the file is made: time to look for neighbours.
  void when_all_made(std::function<Result<void>()> task) { later_.push_back(std::move(task)); }
  Result<void> finish();

  /// Lines for the person who wrote the file.
  void warn(std::string line) { warnings_.push_back(std::move(line)); }
  std::span<const std::string> warnings() const { return warnings_; }

  /// Models that a driver has already given to an interface: (interface, model row).
  std::set<std::pair<std::uint16_t, std::uint32_t>>& taken_models() { return taken_models_; }

 private:
  Surroundings& surroundings_;
  std::uint16_t default_port_;
  std::unique_ptr<Simulation> simulation_;
  Tap tap_;
  std::map<device::Address, Neighbour> devices_;
  std::vector<std::function<Result<void>()>> later_;
  std::vector<std::string> warnings_;
  std::set<std::pair<std::uint16_t, std::uint32_t>> taken_models_;
};

}  // namespace playhouse::drivers
