#pragma once

/// Registry of drivers for `driver ( name "..." )` sections of .cfg files; registry.cc lists them all.

#include <memory>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/site.h"
#include "playhouse/scene/cfg.h"

namespace playhouse::drivers {

/// Makes the drivers of a file, in order, opens those with `alwayson`, and warns of
/// fields that no driver read. Sections of drivers that this program lacks are left out with
/// a warning, and so are those that require their devices. The drivers must outlive everything that refers to
/// them.
Result<std::vector<std::unique_ptr<device::Driver>>> make_drivers(const scene::CfgFile& file, Site& site);

}  // namespace playhouse::drivers
