#pragma once

/// AutoDevices: the devices of a world when nobody wrote a .cfg file: those of AutoMap, of a driver "stage".
/// Models that come during the run get theirs before anybody is shown the world with them; devices of models
/// that go retire as all do (Site), and have the same addresses again should they come back (kReload).
/// Addresses are decided on the tick thread, in the order of the changes.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/drivers/simulated/auto_map.h"
#include "playhouse/drivers/simulated/simulated_driver.h"
#include "playhouse/drivers/site.h"

namespace playhouse::drivers {

class AutoDevices {
 public:
  /// On `port`, of the site's world, which is open. Outlives the run. `indices`: of an interface; less in
  /// tests.
  AutoDevices(Site& site, std::uint16_t port, std::size_t indices = AutoMap::kIndices);
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
  /// Some of `count` models from this one on have devices.
  bool knows(world::ModelId first, std::uint32_t count) const;
  void go(const world::World& world, world::ModelId model);
  void go_and_come_back(const world::World& world);
  void make(const world::World& world, std::span<const MappedDevice> devices);
  void remember(const world::World& world, std::span<const MappedDevice> devices);
  void forget_who_cannot_come_back();
  void warn_of_left_out();

  Site& site_;
  Simulation& simulation_;
  const std::uint16_t port_;
  SimulatedDriver driver_;
  // Tick thread, once it runs.
  AutoMap map_;
  struct Given {
    std::vector<MappedDevice> devices;
    std::optional<std::uint64_t> gone;  // the tick after which the model was there no more
  };
  /// Of every model that is there or can come back.
  std::map<world::ModelId, Given> given_;
  std::size_t forget_at_ = 0;  // so many of given_
  bool warned_ = false;
};

}  // namespace playhouse::drivers
