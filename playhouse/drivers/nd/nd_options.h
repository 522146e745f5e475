#pragma once

/// The options of a section of driver "nd": names, units and defaults as in the original.

#include "playhouse/base/result.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/nd/nd_step.h"
#include "playhouse/drivers/section_fields.h"

namespace playhouse::drivers {

/// Parses the options. Fails with "file:line" on an invalid value.
Result<NdOptions> nd_options(SectionFields fields);

extern const DriverDefinition kNdDriver;

}  // namespace playhouse::drivers
