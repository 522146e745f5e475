#pragma once

/// The .cfg driver "stage": gives models of a Stage world their places among Player's devices
/// (docs/drivers.md).

#include <memory>

#include "playhouse/base/result.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/site.h"
#include "playhouse/scene/cfg.h"

namespace playhouse::drivers {

/// The first section opens the site's world from its `worldfile`, every section adds the devices it provides.
Result<std::unique_ptr<device::Driver>> make_stage_driver(const scene::CfgSection& section, Site& site);

/// The first model, itself and then depth first, that fits the interface and is not yet in `taken` for it;
/// none if there is none.
world::ModelRow find_model(const world::World& world, world::ModelRow top, std::uint16_t interf,
                           const std::set<std::pair<std::uint16_t, std::uint32_t>>& taken);

}  // namespace playhouse::drivers
