#include "playhouse/bridge/all_drivers.h"

#include <vector>

#include "playhouse/bridge/mapfile/map_file.h"
#include "playhouse/bridge/stage_driver/stage_driver.h"
#include "playhouse/drivers/plugin/plugin_shell.h"

namespace playhouse::drivers {

const Registry& all_drivers() {
  static const Registry kAll = [] {
    const auto core = core_drivers();
    std::vector<const DriverDefinition*> drivers(core.begin(), core.end());
    drivers.insert(drivers.end(), {&kMapFileDriver, &kStageDriver});
    return Registry(std::move(drivers), make_plugin);
  }();
  return kAll;
}

}  // namespace playhouse::drivers
