#pragma once

/// The options of a section of driver "vfh": names, units and defaults as in the original.

#include "playhouse/base/result.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/section_fields.h"
#include "playhouse/drivers/vfh/vfh_step.h"

namespace playhouse::drivers {

/// Parses the options. Fails with "file:line" on an invalid value.
Result<VfhOptions> vfh_options(SectionFields fields);

extern const DriverDefinition kVfhDriver;

}  // namespace playhouse::drivers
