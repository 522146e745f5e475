#include "playhouse/drivers/simulated/device_factory.h"

#include <algorithm>
#include <iterator>

#include "playhouse/base/assert.h"
#include "playhouse/drivers/generated/device_makers.h"
#include "playhouse/drivers/simulated/model_interfaces.h"
#include "playhouse/drivers/simulated/simulation_device.h"
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
  driver.add(*id, make_device(*site.model_devices(), address.interf, model, address.robot));
  if (model) site.model_devices()->directory().add(site.simulation()->world().id(model), address);
  return {};
}

}  // namespace playhouse::drivers
