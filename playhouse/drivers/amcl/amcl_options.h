#pragma once

/// The options of a section of driver "amcl": names and units as in the original (docs/drivers.md).

#include <string_view>

#include "playhouse/base/result.h"
#include "playhouse/drivers/amcl/particle_filter.h"
#include "playhouse/scene/cfg.h"

namespace playhouse::drivers {

/// Parses the options; `sensor`: "laser", "ranger" or "sonar", which those of the sensor begin with.
/// Fails with "file:line" on an invalid value.
Result<AmclOptions> amcl_options(const scene::CfgSection& section, std::string_view sensor);

}  // namespace playhouse::drivers
