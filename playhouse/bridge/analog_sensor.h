#pragma once

/// Analog sensors as interface aio: their definitions say of which columns their voltages
/// are (`voltages` in kinds/), and generated/voltages.cc has the functions below.

#include <cstdint>
#include <memory>
#include <vector>

#include "playhouse/bridge/simulated/simulated_device.h"

namespace playhouse::drivers {

/// Sets what the sensor in this row of its table has measured in this tick; false if that is nothing.
using Voltages = bool (*)(const world::World& world, world::KindRow row, std::vector<float>& voltages);

std::unique_ptr<SimulatedDevice> make_analog_sensor(run::Simulation& simulation, world::ModelRow model,
                                                    Voltages voltages);

}  // namespace playhouse::drivers
