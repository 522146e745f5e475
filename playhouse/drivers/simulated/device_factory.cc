#include "playhouse/drivers/simulated/device_factory.h"

#include "playhouse/base/assert.h"
#include "playhouse/drivers/simulated/fiducial.h"
#include "playhouse/drivers/simulated/laser.h"
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

using scene::ModelKind;

bool is_simulated(std::uint16_t interf) {
  switch (interf) {
    case wire::simulation::kCode:
    case wire::position2d::kCode:
    case wire::ranger::kCode:
    case wire::laser::kCode:
    case wire::sonar::kCode:
    case wire::fiducial::kCode:
      return true;
    default:
      return false;
  }
}

bool fits(const world::World& world, world::ModelRow model, std::uint16_t interf) {
  const ModelKind kind = world.models.kind[model.index];
  switch (interf) {
    case wire::position2d::kCode:
      return kind == ModelKind::kPosition;
    case wire::ranger::kCode:
    case wire::sonar::kCode:
      return kind == ModelKind::kRanger;
    case wire::laser::kCode:
      return kind == ModelKind::kRanger && scanner_of(world, model).valid();
    case wire::fiducial::kCode:
      return kind == ModelKind::kFiducial;
    default:
      return false;
  }
}

std::unique_ptr<SimulatedDevice> make_device(Simulation& simulation, std::uint16_t interf,
                                             world::ModelRow model) {
  if (interf == wire::simulation::kCode) return std::make_unique<SimulationDevice>(simulation);
  PLAYHOUSE_ASSERT(fits(simulation.world(), model, interf));
  switch (interf) {
    case wire::position2d::kCode:
      return std::make_unique<Position2d>(simulation, model);
    case wire::ranger::kCode:
      return std::make_unique<Ranger>(simulation, model);
    case wire::laser::kCode:
      return std::make_unique<Laser>(simulation, model);
    case wire::sonar::kCode:
      return std::make_unique<Sonar>(simulation, model);
    default:
      return std::make_unique<Fiducial>(simulation, model);
  }
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
