#pragma once

/// The fields of a section of driver "vfh": names, units and defaults of the original (docs/drivers.md).

#include "playhouse/base/result.h"
#include "playhouse/drivers/vfh/vfh_step.h"
#include "playhouse/scene/cfg.h"

namespace playhouse::drivers {

/// Fails with "file:line" on a value that makes no sense.
Result<VfhOptions> vfh_options(const scene::CfgSection& section);

}  // namespace playhouse::drivers
