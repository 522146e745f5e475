#pragma once

/// The options of a section of driver "nd": names, units and defaults as in the original (docs/drivers.md).

#include "playhouse/base/result.h"
#include "playhouse/drivers/nd/nd_step.h"
#include "playhouse/scene/cfg.h"

namespace playhouse::drivers {

/// Parses the options. Fails with "file:line" on an invalid value.
Result<NdOptions> nd_options(const scene::CfgSection& section);

}  // namespace playhouse::drivers
