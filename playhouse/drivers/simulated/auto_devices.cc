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
  const std::vector<MappedDevice> devices = map_.of_world(simulation_.world());
  remember(simulation_.world(), devices);
  for (const MappedDevice& mapped : devices) {
    const Result<void> added =
        add_simulated_device(site_, driver_, {port_, mapped.interf, mapped.index}, mapped.model);
    if (!added) return added;
  }
  return {};
}

void AutoDevices::follow(const world::World& world, const world::Change& change) {
  if (change.kind == world::Change::Kind::kReload) return come_back(world);
  if (change.kind != world::Change::Kind::kSpawn) return;
  const world::ModelRow top = world.row(change.model);
  if (top) come(world, {{top}});  // else it went again before anybody could look
}

void AutoDevices::come(const world::World& world, std::span<const world::ModelRow> tops) {
  const std::vector<MappedDevice> devices = map_.of_trees(world, tops);
  remember(world, devices);
  make(world, devices);
  warn_of_left_out();
}

void AutoDevices::come_back(const world::World& world) {
  std::vector<MappedDevice> devices;
  for (std::uint32_t row = 0; row < world.models.size(); ++row) {
    const auto given = given_.find(world.models.id[row]);
    if (given == given_.end() || !simulation_.directory().devices_of(given->first).empty()) continue;
    for (MappedDevice device : given->second) {
      device.model = {row};
      devices.push_back(device);
    }
  }
  make(world, devices);
}

void AutoDevices::make(const world::World& world, std::span<const MappedDevice> devices) {
  struct Made {
    device::Address address;
    std::shared_ptr<SimulatedDevice> device;
  };
  std::vector<Made> made;
  for (const MappedDevice& mapped : devices) {
    const device::Address address{port_, mapped.interf, mapped.index};
    simulation_.directory().add(world.id(mapped.model), address);
    made.push_back({address, make_device(simulation_, mapped.interf, mapped.model)});
  }
  if (made.empty()) return;
  site_.surroundings().post([this, made = std::move(made)] {
    // An address that the map gives is nobody else's.
    for (const auto& [address, device] : made) driver_.add(*site_.add_device(address, driver_), device);
  });
}

void AutoDevices::remember(const world::World& world, std::span<const MappedDevice> devices) {
  for (const MappedDevice& mapped : devices)
    if (mapped.model) given_[world.id(mapped.model)].push_back(mapped);
}

void AutoDevices::warn_of_left_out() {
  if (map_.left_out() == 0 || std::exchange(warned_, true)) return;
  log::warn("models that come get no more devices: an interface has 65536 indices, and none is given twice");
}

}  // namespace playhouse::drivers
