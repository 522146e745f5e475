#include "playhouse/drivers/simulated/simulated_driver.h"

#include <algorithm>
#include <utility>

#include "playhouse/base/assert.h"

namespace playhouse::drivers {

void SimulatedDriver::add(device::DeviceId id, std::unique_ptr<SimulatedDevice> device) {
  device->set_id(id);
  devices_[id] = std::move(device);
}

SimulatedDevice& SimulatedDriver::at(device::DeviceId id) const {
  const auto found = devices_.find(id);
  PLAYHOUSE_ASSERT(found != devices_.end());
  return *found->second;
}

Result<void> SimulatedDriver::start(device::DeviceId id) {
  SimulatedDevice& device = at(id);
  const auto open = [&device, &simulation = simulation_](world::World& world) {
    simulation.add_source(device);
    if (const world::ModelRow model = world.row(device.model())) world::subscribe(world, model);
  };
  // A device opened as the run ends is no failure: its client is told of the end next.
  if (!simulation_.post(open, device.robot()) && !simulation_.discarded())
    return Error{"", "too many requests are waiting for the tick"};
  return {};
}

void SimulatedDriver::stop(device::DeviceId id) {
  SimulatedDevice& device = at(id);
  simulation_.post_always(
      [&device, &simulation = simulation_](world::World& world) {
        simulation.remove_source(device);
        const world::ModelRow model = world.row(device.model());
        if (!model) return;
        world::unsubscribe(world, model);
        device.closed(world, model);
      },
      device.robot());
}

device::Taken SimulatedDriver::command(const device::Message& message) {
  if (!capable(message.device, message.type, message.subtype)) return device::Taken::kNo;
  return at(message.device).command(message);
}

void SimulatedDriver::request(const device::Message& message, device::Replier replier) {
  if (!capable(message.device, message.type, message.subtype)) return;
  at(message.device).request(message, std::move(replier));
}

bool SimulatedDriver::capable(device::DeviceId id, std::uint8_t type, std::uint8_t subtype) const {
  return std::ranges::any_of(at(id).served(), [=](const Served& served) {
    return static_cast<std::uint8_t>(served.type) == type && served.subtype == subtype;
  });
}

void SimulatedDriver::barrier(device::Replier replier) {
  auto shared = std::make_shared<device::Replier>(std::move(replier));  // std::function wants to be copied
  simulation_.post_always([shared](world::World&) { shared->ack(); }, {});
}

}  // namespace playhouse::drivers
