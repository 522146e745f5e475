#pragma once

/// SimulatedWorld: the run that drivers of a site share, and the devices of its models.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <span>
#include <utility>

#include "playhouse/base/result.h"
#include "playhouse/bridge/simulated/model_devices.h"
#include "playhouse/drivers/site.h"
#include "playhouse/drivers/site_world.h"
#include "playhouse/run/simulation.h"

namespace playhouse::drivers {

class SimulatedWorld final : public SiteWorld {
 public:
  /// Devices of models publish through the site, which retires those of removed models.
  SimulatedWorld(Site& site, std::unique_ptr<run::Simulation> simulation);

  run::Simulation& simulation() { return *simulation_; }
  ModelDevices& devices() { return devices_; }
  /// Models already assigned to an interface: (interface, model row).
  std::set<std::pair<std::uint16_t, std::uint32_t>>& taken_models() { return taken_models_; }

  double time() const override { return simulation_->time(); }
  void between_ticks(std::function<void()> task) override;
  void forget(device::Address device) override { devices_.directory().remove(device); }
  std::size_t sensors_of(device::Address device) const override;
  Moment join(device::Address robot, std::span<const device::Address> own, RunListener& listener) override;

 private:
  void happened(const world::World& world, const world::Event& event);

  Site& site_;
  std::unique_ptr<run::Simulation> simulation_;
  ModelDevices devices_;
  std::set<std::pair<std::uint16_t, std::uint32_t>> taken_models_;
};

/// For Host::open_world(): the world of a run, or the error.
Result<std::unique_ptr<SiteWorld>> simulated_world(Site& site,
                                                   Result<std::unique_ptr<run::Simulation>> simulation);

/// The world of a site; null before one is opened.
SimulatedWorld* world_of(const Site& site);
/// Its run; null likewise.
run::Simulation* simulation_of(const Site& site);
/// The devices of its models; null likewise.
ModelDevices* model_devices_of(const Site& site);

}  // namespace playhouse::drivers
