#pragma once

#include <memory>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/registry.h"
#include "playhouse/drivers/site.h"

namespace playhouse::drivers {

/// All drivers there are, those of simulated worlds and plug-ins as well.
const Registry& all_drivers();

/// The drivers of a run without a file, which serve devices of the program itself: blackboard:0 and health:0 of
/// the default port. The world must be open.
Result<std::vector<std::unique_ptr<device::Driver>>> make_drivers_of_program(Site& site);

}  // namespace playhouse::drivers
