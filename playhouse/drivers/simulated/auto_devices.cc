#include "playhouse/drivers/simulated/auto_devices.h"

#include <memory>
#include <utility>
#include <vector>

#include "playhouse/base/log.h"
#include "playhouse/drivers/simulated/device_factory.h"

namespace playhouse::drivers {

AutoDevices::AutoDevices(Site& site, std::uint16_t port)
    : site_(site), simulation_(*site.simulation()), port_(port), driver_(simulation_, "stage") {
  simulation_.add_follower(
      [this](const world::World& world, const world::Change& change) { follow(world, change); });
}

Result<void> AutoDevices::add_all() {
  for (const MappedDevice& mapped : map_.of_world(simulation_.world())) {
    const Result<void> added =
        add_simulated_device(site_, driver_, {port_, mapped.interf, mapped.index}, mapped.model);
    if (!added) return added;
  }
  return {};
}

void AutoDevices::follow(const world::World& world, const world::Change& change) {
  if (change.kind == world::Change::Kind::kReload) return come(world, top_models(world));
  if (change.kind != world::Change::Kind::kSpawn) return;
  const world::ModelRow top = world.row(change.model);
  if (top) come(world, {{top}});  // else it went again before anybody could look
}

void AutoDevices::come(const world::World& world, std::span<const world::ModelRow> tops) {
  struct Made {
    device::Address address;
    std::shared_ptr<SimulatedDevice> device;
  };
  std::vector<Made> made;
  for (const MappedDevice& mapped : map_.of_trees(world, tops)) {
    const device::Address address{port_, mapped.interf, mapped.index};
    simulation_.directory().add(world.id(mapped.model), address);
    made.push_back({address, make_device(simulation_, mapped.interf, mapped.model)});
  }
  warn_of_left_out();
  if (made.empty()) return;
  site_.surroundings().post([this, made = std::move(made)] {
    // An address that the map gives is nobody's.
    for (const auto& [address, device] : made) driver_.add(*site_.add_device(address, driver_), device);
  });
}

void AutoDevices::warn_of_left_out() {
  if (map_.left_out() == 0 || std::exchange(warned_, true)) return;
  log::warn("models that come get no more devices: an interface has 65536 indices, and none is given twice");
}

}  // namespace playhouse::drivers
