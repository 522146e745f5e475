#pragma once

/// AutoDevices: the devices of a world without a .cfg file: those of AutoMap, served by a
/// driver "stage". Models spawned during the run get devices before anybody sees the world with
/// them; devices of removed models retire (Site), and get the same addresses if the models come
/// back (kReload). Addresses are assigned on the tick thread, in the order of the change log. A port
/// has few indices: further devices are on the following ports, which are opened during the run as needed.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/bridge/simulated/auto_map.h"
#include "playhouse/bridge/simulated/simulated_driver.h"
#include "playhouse/drivers/site.h"

namespace playhouse::drivers {

class AutoDevices : private run::Follower {
 public:
  /// Devices on `port` and those behind it, for the site's open world. Must
  /// outlive the run. `indices`: per interface and port; smaller in tests.
  AutoDevices(Site& site, std::uint16_t port, std::size_t indices = AutoMap::kIndices);
  AutoDevices(const AutoDevices&) = delete;
  AutoDevices& operator=(const AutoDevices&) = delete;

  /// Adds the devices of the present world, before the run. Fails if an address is taken.
  /// From now on further ports are opened here; the caller opens the ports() that are in use already.
  Result<void> add_all();
  /// Number of ports in use, from `port` on.
  std::size_t ports() const { return map_.ports(); }

  /// Number of devices without an address (AutoMap).
  std::size_t left_out() const { return map_.left_out(); }
  const SimulatedDriver& driver() const { return driver_; }

 private:
  void happened(const world::World& world, const world::Event& event) override;
  void come(const world::World& world, std::span<const world::ModelRow> tops);
  /// True if some of `count` models from this one on have devices.
  bool knows(world::ModelId first, std::uint32_t count) const;
  void go(const world::World& world, world::ModelId model);
  void go_and_come_back(const world::World& world);
  void make(const world::World& world, std::span<const MappedDevice> devices);
  bool open_port(std::size_t number);
  device::Address address_of(const MappedDevice& mapped) const;
  void remember(const world::World& world, std::span<const MappedDevice> devices);
  void forget_who_cannot_come_back();
  void warn_of_left_out();

  Site& site_;
  run::Simulation& simulation_;
  const std::uint16_t port_;
  SimulatedDriver driver_;
  // Tick thread, once it runs.
  AutoMap map_;
  struct GivenDevices {
    std::vector<MappedDevice> devices;
    std::optional<std::uint64_t> gone;  // the tick after which the model was removed
  };
  /// Of every model that exists or can come back.
  std::map<world::ModelId, GivenDevices> given_;
  std::size_t forget_at_ = 0;  // size of given_ that triggers clean-up
  bool opens_ports_ = false;
  bool warned_ = false;
};

}  // namespace playhouse::drivers
