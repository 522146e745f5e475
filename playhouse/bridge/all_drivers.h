#pragma once

#include "playhouse/drivers/registry.h"

namespace playhouse::drivers {

/// All drivers there are, those of simulated worlds and plug-ins as well.
const Registry& all_drivers();

}  // namespace playhouse::drivers
