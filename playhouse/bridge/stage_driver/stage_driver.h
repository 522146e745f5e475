#pragma once

/// The .cfg driver "stage": assigns Player device
/// addresses to models of a Stage world (docs/drivers.md).

#include <memory>

#include "playhouse/base/result.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/site.h"

namespace playhouse::drivers {

/// The first section opens the site's world by its `worldfile`; every section adds its `provides` devices.
Result<std::unique_ptr<device::Driver>> make_stage_driver(const config::CfgSection& section, Site& site);

extern const DriverDefinition kStageDriver;

}  // namespace playhouse::drivers
