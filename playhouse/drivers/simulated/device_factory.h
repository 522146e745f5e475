#pragma once

/// Which interfaces a simulated model can have, and the devices for them.

#include <cstdint>
#include <memory>

#include "playhouse/drivers/simulated/simulated_device.h"

namespace playhouse::drivers {

/// True for interfaces that simulated devices can have.
bool is_simulated(std::uint16_t interf);

/// True when a model can be seen through an interface: its kind fits, and a laser has a scanner. Never for
/// the interface simulation, which belongs to the whole world.
bool fits(const world::World& world, world::ModelRow model, std::uint16_t interf);

/// The device; `model` fits the interface (asserted), or is none for the interface simulation.
std::unique_ptr<SimulatedDevice> make_device(Simulation& simulation, std::uint16_t interf,
                                             world::ModelRow model);

}  // namespace playhouse::drivers
