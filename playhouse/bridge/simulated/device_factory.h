#pragma once

/// Factory of the devices of simulated models, a class for each interface.

#include <cstdint>
#include <memory>

#include "playhouse/base/result.h"
#include "playhouse/bridge/simulated/simulated_device.h"
#include "playhouse/bridge/simulated/simulated_driver.h"
#include "playhouse/device/address.h"
#include "playhouse/drivers/site.h"

namespace playhouse::drivers {

/// `model` must fit the interface (asserted), or be none for the interface simulation,
/// whose clients get the addresses of devices on other ports than `port` with their ports.
std::unique_ptr<SimulatedDevice> make_device(ModelDevices& devices, std::uint16_t interf,
                                             world::ModelRow model, std::uint32_t port = 0);

/// Registers the device of a model, or of the world, at an address: with
/// the server, its driver and the directory. Fails if the address is taken.
Result<void> add_simulated_device(Site& site, SimulatedDriver& driver, device::Address address,
                                  world::ModelRow model);

}  // namespace playhouse::drivers
