#pragma once

/// Registry: which driver a `driver ( name "..." )` section of a .cfg file means. register_drivers() lists
/// them all.

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/site.h"
#include "playhouse/scene/cfg.h"

namespace playhouse::drivers {

/// Makes the driver of one section and adds its devices to the site. Errors carry "file:line".
using Factory = std::function<Result<std::unique_ptr<device::Driver>>(const scene::CfgSection&, Site&)>;

class Registry {
 public:
  void add(std::string name, Factory factory) { factories_[std::move(name)] = std::move(factory); }
  Result<std::unique_ptr<device::Driver>> make(const scene::CfgSection& section, Site& site) const;

 private:
  std::map<std::string, Factory> factories_;
};

/// Every driver of this program.
void register_drivers(Registry& registry);

/// Makes the drivers of a file, in its order, opens those that are `alwayson`, and warns of fields that no
/// driver read. The drivers must outlive everything that was told about them.
Result<std::vector<std::unique_ptr<device::Driver>>> make_drivers(const Registry& registry,
                                                                  const scene::CfgFile& file, Site& site);

}  // namespace playhouse::drivers
