#include "playhouse/bridge/simulated/simulated_world.h"

#include <vector>

namespace playhouse::drivers {

SimulatedWorld::SimulatedWorld(Site& site, std::unique_ptr<run::Simulation> simulation)
    : site_(site), simulation_(std::move(simulation)), devices_(*simulation_, site.data_flow()) {
  simulation_->follow(run::on_event(
      [this](const world::World& world, const world::Event& event) { happened(world, event); }));
}

void SimulatedWorld::between_ticks(std::function<void()> task) {
  simulation_->requests().post_always([task = std::move(task)](const world::Journal&) { task(); }, {});
}

std::size_t SimulatedWorld::sensors_of(device::Address device) const {
  const world::World& world = simulation_->world();
  const world::ModelRow model = world.row(devices_.directory().model_of(device));
  return model ? world.desc(model).sensors.size() : 1;
}

Moment SimulatedWorld::join(device::Address robot, std::span<const device::Address> own,
                            RunListener& listener) {
  Directory& directory = devices_.directory();
  const world::ModelId model = directory.model_of(robot);
  for (const device::Address& device : own) directory.add(model, device);
  simulation_->follow(run::on_event([&listener, model](const world::World& world, const world::Event& event) {
    if (event.kind == world::Event::EventKind::kReload)
      listener.rewound({world.tick(), world.time(), world.seed()});
    if (event.kind == world::Event::EventKind::kPlace && event.model == model) listener.placed();
  }));
  simulation_->follow(run::on_show(
      [&listener](const world::World& world, const world::Pace&) { listener.ticked(world.tick()); }));
  const world::World& now = simulation_->world();
  return {now.tick(), now.time(), now.seed()};
}

void SimulatedWorld::happened(const world::World& world, const world::Event& event) {
  using EventKind = world::Event::EventKind;
  const Directory& directory = devices_.directory();
  std::vector<device::Address> gone;
  if (event.kind == EventKind::kReload) {
    for (const device::Address& address : directory.devices())
      if (!world.row(directory.model_of(address))) gone.push_back(address);
    return gone.empty() ? void() : site_.retire(std::move(gone));
  }
  if (event.kind != EventKind::kDespawn) return;
  for (std::uint32_t part = 0; part < event.count; ++part) {
    const auto devices = directory.devices_of({event.model.value + part});
    gone.insert(gone.end(), devices.begin(), devices.end());
  }
  if (!gone.empty()) site_.retire(std::move(gone));
}

Result<std::unique_ptr<SiteWorld>> simulated_world(Site& site,
                                                   Result<std::unique_ptr<run::Simulation>> simulation) {
  if (!simulation) return simulation.error();
  return std::unique_ptr<SiteWorld>(std::make_unique<SimulatedWorld>(site, std::move(*simulation)));
}

SimulatedWorld* world_of(const Site& site) {
  return static_cast<SimulatedWorld*>(site.world());  // there is no other kind
}

run::Simulation* simulation_of(const Site& site) {
  SimulatedWorld* const world = world_of(site);
  return world == nullptr ? nullptr : &world->simulation();
}

ModelDevices* model_devices_of(const Site& site) {
  SimulatedWorld* const world = world_of(site);
  return world == nullptr ? nullptr : &world->devices();
}

}  // namespace playhouse::drivers
