#include "playhouse/bridge/all_drivers.h"

#include <vector>

#include "playhouse/bridge/mapfile/map_file.h"
#include "playhouse/bridge/stage_driver/stage_driver.h"
#include "playhouse/config/cfg.h"
#include "playhouse/drivers/plugin/plugin_shell.h"

namespace playhouse::drivers {
namespace {

/// What does instead of a driver of Player that this program does not have.
constexpr Registry::Instead kInstead[] = {
    {"readlog", "; \"playhouse replay\" shows a recording"},
    {"writelog", "; the option --record records a run"},
};

constexpr const char* kDriversOfProgram = R"(
driver ( name "localbb" provides ["blackboard:0"] )
driver ( name "health" provides ["health:0"] )
)";

}  // namespace

const Registry& all_drivers() {
  static const Registry kAll = [] {
    const auto core = core_drivers();
    std::vector<const DriverDefinition*> drivers(core.begin(), core.end());
    drivers.insert(drivers.end(), {&kMapFileDriver, &kStageDriver});
    return Registry(std::move(drivers), {make_plugin, plugin_is_there}, kInstead);
  }();
  return kAll;
}

Result<std::vector<std::unique_ptr<device::Driver>>> make_drivers_of_program(Site& site) {
  config::MemoryFiles none({});
  const Result<config::CfgFile> file =
      config::load_cfg_text(kDriversOfProgram, "drivers of the program", none);
  return file ? all_drivers().make(*file, site) : file.error();
}

}  // namespace playhouse::drivers
