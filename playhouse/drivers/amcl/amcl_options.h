#pragma once

/// The options of a section of driver "amcl": names and units as in the original.

#include <string_view>

#include "playhouse/base/result.h"
#include "playhouse/drivers/amcl/particle_filter.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/section_fields.h"

namespace playhouse::drivers {

/// Parses the options; `sensor`: "laser", "ranger" or "sonar", which those of the sensor begin with.
/// Fails with "file:line" on an invalid value.
Result<AmclOptions> amcl_options(SectionFields fields, std::string_view sensor);

extern const DriverDefinition kAmclDriver;

}  // namespace playhouse::drivers
