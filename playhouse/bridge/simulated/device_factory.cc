#include "playhouse/bridge/simulated/device_factory.h"

#include <algorithm>
#include <iterator>

#include "playhouse/base/assert.h"
#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/simulated/model_interfaces.h"
#include "playhouse/bridge/simulated/simulated_world.h"
#include "playhouse/bridge/simulated/simulation_device.h"
#include "playhouse/wire/generated/simulation.h"

namespace playhouse::drivers {

std::unique_ptr<SimulatedDevice> make_device(ModelDevices& devices, std::uint16_t interf,
                                             world::ModelRow model, std::uint32_t port) {
  if (!model) {
    PLAYHOUSE_ASSERT(interf == wire::simulation::kCode);
    return std::make_unique<SimulationDevice>(devices, port);
  }
  run::Simulation& simulation = devices.simulation();
  PLAYHOUSE_ASSERT(fits(simulation.world(), model, interf));
  const scene::ModelKind kind = simulation.world().models.kind[model];
  const auto found = std::ranges::find_if(kDeviceMakers, [&](const DeviceMaker& maker) {
    return maker.interf == interf && maker.kind.value_or(kind) == kind;
  });
  PLAYHOUSE_ASSERT(found != std::end(kDeviceMakers));
  return found->make(simulation, model);
}

Result<void> add_simulated_device(Site& site, SimulatedDriver& driver, device::Address address,
                                  world::ModelRow model) {
  const Result<device::DeviceId> id = site.add_device(address, driver);
  if (!id) return id.error();
  driver.add(*id, make_device(*model_devices_of(site), address.interf, model, address.robot));
  if (model) model_devices_of(site)->directory().add(simulation_of(site)->world().id(model), address);
  return {};
}

}  // namespace playhouse::drivers
