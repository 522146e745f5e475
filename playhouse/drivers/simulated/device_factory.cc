#include "playhouse/drivers/simulated/device_factory.h"

#include <algorithm>
#include <iterator>

#include "playhouse/base/assert.h"
#include "playhouse/drivers/simulated/fiducial.h"
#include "playhouse/drivers/simulated/laser.h"
#include "playhouse/drivers/simulated/model_interfaces.h"
#include "playhouse/drivers/simulated/position2d.h"
#include "playhouse/drivers/simulated/ranger.h"
#include "playhouse/drivers/simulated/simulation_device.h"
#include "playhouse/drivers/simulated/sonar.h"
#include "playhouse/wire/generated/fiducial.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/ranger.h"
#include "playhouse/wire/generated/simulation.h"
#include "playhouse/wire/generated/sonar.h"

namespace playhouse::drivers {

namespace {

using Made = std::unique_ptr<SimulatedDevice>;

struct DeviceClass {
  std::uint16_t interf;
  Made (*make)(Simulation& simulation, world::ModelRow model);
};

template <typename Device>
Made of_model(Simulation& simulation, world::ModelRow model) {
  PLAYHOUSE_ASSERT(model.valid());
  return std::make_unique<Device>(simulation, model);
}

template <typename Device>
Made of_world(Simulation& simulation, world::ModelRow model) {
  PLAYHOUSE_ASSERT(!model);
  return std::make_unique<Device>(simulation);
}

constexpr DeviceClass kClasses[] = {
    {wire::simulation::kCode, of_world<SimulationDevice>},
    {wire::position2d::kCode, of_model<Position2d>},
    {wire::ranger::kCode, of_model<Ranger>},
    {wire::laser::kCode, of_model<Laser>},
    {wire::sonar::kCode, of_model<Sonar>},
    {wire::fiducial::kCode, of_model<Fiducial>},
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_device(Simulation& simulation, std::uint16_t interf,
                                             world::ModelRow model) {
  PLAYHOUSE_ASSERT(!model || fits(simulation.world(), model, interf));
  const auto found = std::ranges::find(kClasses, interf, &DeviceClass::interf);
  PLAYHOUSE_ASSERT(found != std::end(kClasses));
  return found->make(simulation, model);
}

Result<void> add_simulated_device(Site& site, SimulatedDriver& driver, device::Address address,
                                  world::ModelRow model) {
  const Result<device::DeviceId> id = site.add_device(address, driver);
  if (!id) return id.error();
  driver.add(*id, make_device(*site.simulation(), address.interf, model));
  if (model) site.simulation()->directory().add(site.simulation()->world().id(model), address);
  return {};
}

}  // namespace playhouse::drivers
