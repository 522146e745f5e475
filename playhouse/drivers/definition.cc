#include "playhouse/drivers/definition.h"

#include <fmt/format.h>

#include "playhouse/base/assert.h"

namespace playhouse::drivers {

std::vector<Option> options_of(const DriverDefinition& driver) {
  if (driver.read_options == nullptr) return {};
  config::MemoryFiles none({});
  const std::string bare = fmt::format("driver( name \"{}\" provides [\"opaque:0\"] )", driver.name);
  const Result<config::CfgFile> file = config::load_cfg_text(bare, "", none);
  PLAYHOUSE_ASSERT(file);
  std::vector<Option> told;
  driver.read_options(SectionFields(file->drivers.front(), &told));
  return told;
}

}  // namespace playhouse::drivers
