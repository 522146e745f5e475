#pragma once

/// The options of a section of driver "wavefront": names, units and defaults as in the original.

#include "playhouse/base/result.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/section_fields.h"
#include "playhouse/drivers/wavefront/follow_path.h"

namespace playhouse::drivers {

/// Parses the options. Fails with "file:line" on an invalid value.
Result<WavefrontOptions> wavefront_options(SectionFields fields);

extern const DriverDefinition kWavefrontDriver;

}  // namespace playhouse::drivers
