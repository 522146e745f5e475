#pragma once

/// AutoDevices: the devices of a world when nobody wrote a .cfg file: those of AutoMap, of a driver "stage".
/// Models that come during the run get theirs before anybody is shown the world with them; devices of models
/// that go retire as all do (Site), and have the same addresses again should they come back (kReload).
/// Addresses are decided on the tick thread, in the order of the changes.

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/drivers/simulated/auto_map.h"
#include "playhouse/drivers/simulated/simulated_driver.h"
#include "playhouse/drivers/site.h"

namespace playhouse::drivers {

class AutoDevices {
 public:
  /// On `port`, of the site's world, which is open. Outlives the run.
  AutoDevices(Site& site, std::uint16_t port);
  AutoDevices(const AutoDevices&) = delete;
  AutoDevices& operator=(const AutoDevices&) = delete;

  /// Makes those of the world as it is; before the run. Fails where an address is taken.
  Result<void> add_all();

  /// Those that got no address (AutoMap).
  std::size_t left_out() const { return map_.left_out(); }
  const SimulatedDriver& driver() const { return driver_; }

 private:
  void follow(const world::World& world, const world::Change& change);
  void come(const world::World& world, std::span<const world::ModelRow> tops);
  void come_back(const world::World& world);
  void make(const world::World& world, std::span<const MappedDevice> devices);
  void remember(const world::World& world, std::span<const MappedDevice> devices);
  void warn_of_left_out();

  Site& site_;
  Simulation& simulation_;
  const std::uint16_t port_;
  SimulatedDriver driver_;
  // Tick thread, once it runs.
  AutoMap map_;
  /// Of every model that ever was: as many as AutoMap has indices.
  std::map<world::ModelId, std::vector<MappedDevice>> given_;
  bool warned_ = false;
};

}  // namespace playhouse::drivers
