#include "playhouse/bridge/simulated/auto_devices.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "playhouse/base/log.h"
#include "playhouse/bridge/simulated/device_factory.h"
#include "playhouse/bridge/simulated/simulated_world.h"

namespace playhouse::drivers {

AutoDevices::AutoDevices(Site& site, std::uint16_t port, std::size_t indices)
    : site_(site),
      simulation_(*simulation_of(site)),
      port_(port),
      driver_(*model_devices_of(site), "stage"),
      map_(indices, [this](std::size_t number) { return open_port(number); }) {
  simulation_.follow(*this);
}

Result<void> AutoDevices::add_all() {
  const std::vector<MappedDevice> devices = map_.of_world(simulation_.world());
  remember(simulation_.world(), devices);
  for (const MappedDevice& mapped : devices) {
    const Result<void> added = add_simulated_device(site_, driver_, address_of(mapped), mapped.model);
    if (!added) return added;
  }
  opens_ports_ = true;
  return {};
}

device::Address AutoDevices::address_of(const MappedDevice& mapped) const {
  return {static_cast<std::uint32_t>(port_) + mapped.port, mapped.interf, mapped.index};
}

bool AutoDevices::open_port(std::size_t number) {
  if (!opens_ports_) return true;
  const Result<void> opened = site_.surroundings().open_port(static_cast<std::uint32_t>(port_ + number));
  if (opened) return true;
  warned_ = true;
  log::warn(
      "{}; models that come have fewer devices: an interface has {} indices on a port, and none is free",
      opened.error().line(), map_.indices());
  return false;
}

void AutoDevices::happened(const world::World& world, const world::Event& event) {
  using EventKind = world::Event::EventKind;
  if (event.kind == EventKind::kReload) return go_and_come_back(world);
  if (event.kind == EventKind::kDespawn)
    for (std::uint32_t part = 0; part < event.count; ++part) go(world, {event.model.value + part});
  if (event.kind != EventKind::kSpawn) return;
  const world::ModelRow top = world.row(event.model);
  // Otherwise it was removed again already, or spawned with its parent.
  if (top && !knows(event.model, event.count)) come(world, {{top}});
}

bool AutoDevices::knows(world::ModelId first, std::uint32_t count) const {
  const auto end = given_.lower_bound({first.value + count});
  return std::any_of(given_.lower_bound(first), end, [](const auto& each) { return !each.second.gone; });
}

void AutoDevices::come(const world::World& world, std::span<const world::ModelRow> tops) {
  const std::vector<MappedDevice> devices = map_.of_trees(world, tops);
  remember(world, devices);
  make(world, devices);
  warn_of_left_out();
  forget_who_cannot_come_back();
}

void AutoDevices::go(const world::World& world, world::ModelId model) {
  const auto given = given_.find(model);
  if (given == given_.end() || given->second.gone) return;
  given->second.gone = world.tick();
  for (const MappedDevice& device : given->second.devices) map_.retire(device, world.time());
}

/// An existing model owns its addresses in any retained state: they were
/// given to others only after its removal, so both never exist together.
void AutoDevices::go_and_come_back(const world::World& world) {
  map_.rewind_to(world.time());
  for (auto& [model, given] : given_) {
    if (given.gone) given.gone = std::min(*given.gone, world.tick());
    if (!world.row(model)) go(world, model);
  }
  std::vector<MappedDevice> devices;
  for (auto& [model, given] : given_) {
    const world::ModelRow row = world.row(model);
    if (!row || !std::exchange(given.gone, std::nullopt)) continue;
    for (MappedDevice device : given.devices) {
      map_.come_back(device);
      device.model = row;
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
    const device::Address address = address_of(mapped);
    if (mapped.model) model_devices_of(site_)->directory().add(world.id(mapped.model), address);
    made.push_back(
        {address, make_device(*model_devices_of(site_), mapped.interf, mapped.model, address.robot)});
  }
  if (made.empty()) return;
  site_.surroundings().post([this, made = std::move(made)] {
    // Addresses from the map are unused.
    for (const auto& [address, device] : made) driver_.add(*site_.add_device(address, driver_), device);
  });
}

void AutoDevices::remember(const world::World& world, std::span<const MappedDevice> devices) {
  for (const MappedDevice& mapped : devices) {
    if (!mapped.model) continue;
    GivenDevices& given = given_[world.id(mapped.model)];
    // The id was used by another model before a rewind or restart, which cannot come back.
    if (given.gone) given = {};
    given.devices.push_back(mapped);
  }
}

/// Amortised clean-up of entries that no retained state can
/// restore: of models removed before the first of them.
void AutoDevices::forget_who_cannot_come_back() {
  constexpr std::size_t kLeast = 1024;
  if (given_.size() < std::max(kLeast, forget_at_)) return;
  const std::vector<std::uint64_t>& instants = simulation_.requests().timeline()->ticks;
  std::erase_if(given_, [&](const auto& each) {
    const std::optional<std::uint64_t>& gone = each.second.gone;
    return gone && (instants.empty() || *gone < instants.front());
  });
  forget_at_ = 2 * given_.size();
}

void AutoDevices::warn_of_left_out() {
  if (map_.left_out() == 0 || std::exchange(warned_, true)) return;
  log::warn(
      "models that come have fewer devices: an interface has {} indices on each of {} ports, none is free",
      map_.indices(), map_.ports());
}

}  // namespace playhouse::drivers
