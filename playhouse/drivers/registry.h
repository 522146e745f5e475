#pragma once

/// Registry of drivers for `driver ( name "..." )` sections of .cfg files; registry.cc lists them all.

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/site.h"
#include "playhouse/scene/cfg.h"

namespace playhouse::drivers {

/// Every driver that a section may name, in the order of their names.
std::span<const DriverDefinition* const> driver_definitions();
/// That of a name, or null.
const DriverDefinition* find_driver(std::string_view name);
/// What to write instead of a name that no driver has: "", " (did you mean "vfh"?)", or "; " and what
/// this program has for it.
std::string what_instead_of_driver(std::string_view name);

/// Makes the drivers of a file, in order, opens those with `alwayson`, and warns of
/// fields that no driver read. Sections of drivers that this program lacks are left out with
/// a warning, and so are those that require their devices. The drivers must outlive everything that refers to
/// them.
Result<std::vector<std::unique_ptr<device::Driver>>> make_drivers(const scene::CfgFile& file, Site& site);

/// The drivers of a run without a file, which serve devices of the program itself: blackboard:0 and health:0 of
/// the default port. The world must be open.
Result<std::vector<std::unique_ptr<device::Driver>>> make_drivers_of_program(Site& site);

}  // namespace playhouse::drivers
