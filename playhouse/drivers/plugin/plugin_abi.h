#pragma once

#include "playhouse/drivers/plugin/plugin.h"
#include "playhouse/libraries/shared_library.h"

namespace playhouse::drivers {

/// What libraries with a driver export.
inline constexpr libraries::LibraryAbi kPluginAbi{.what = "driver",
                                                  .macro = "PLAYHOUSE_DRIVER",
                                                  .prefix = "playhouse_driver",
                                                  .version_least = kPluginVersionLeast,
                                                  .version = kPluginVersion};

}  // namespace playhouse::drivers
