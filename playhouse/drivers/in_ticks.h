#pragma once

/// Drivers with an AlgorithmThread in a simulated world.

#include <functional>
#include <span>

#include "playhouse/device/address.h"
#include "playhouse/drivers/algorithm_thread.h"
#include "playhouse/drivers/site.h"

namespace playhouse::drivers {

/// For `connected` of a driver: its devices belong to the model of the device `robot`, results of its thread
/// are due one tick after the step was posted, and `reloaded` is called when another state of the run was
/// loaded (tick thread). No effect without a world. All must outlive the simulation.
void run_in_ticks(Site& site, std::span<const device::Address> devices, device::Address robot,
                  AlgorithmThread& thread, std::function<void(const world::World&)> reloaded);

}  // namespace playhouse::drivers
