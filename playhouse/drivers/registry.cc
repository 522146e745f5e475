#include "playhouse/drivers/registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/drivers/amcl/amcl.h"
#include "playhouse/drivers/mapfile/map_file.h"
#include "playhouse/drivers/nd/nd.h"
#include "playhouse/drivers/passthrough/passthrough.h"
#include "playhouse/drivers/rangertolaser/ranger_to_laser.h"
#include "playhouse/drivers/relay/relay.h"
#include "playhouse/drivers/stage_driver/stage_driver.h"
#include "playhouse/drivers/vfh/vfh.h"
#include "playhouse/drivers/wavefront/wavefront.h"

namespace playhouse::drivers {
namespace {

/// Makes the driver of a section and registers its devices. Errors carry "file:line".
using Factory = Result<std::unique_ptr<device::Driver>> (*)(const scene::CfgSection&, Site&);

/// All drivers, by name.
constexpr std::pair<std::string_view, Factory> kDrivers[] = {
    {"amcl", make_amcl},
    {"mapfile", make_map_file},
    {"nd", make_nd},
    {"passthrough", make_passthrough},
    {"rangertolaser", make_ranger_to_laser},
    {"relay", make_relay},
    {"stage", make_stage_driver},
    {"vfh", make_vfh},
    {"wavefront", make_wavefront},
};

Result<std::unique_ptr<device::Driver>> make_driver(const scene::CfgSection& section, Site& site) {
  std::vector<std::string_view> names;
  for (const auto& [name, make] : kDrivers) {
    if (name == section.name()) return make(section, site);
    names.push_back(name);
  }
  return Error{section.at("name"),
               fmt::format("there is no driver {}{}; this program has {}", in_quotes(section.name()),
                           did_you_mean(section.name(), names), fmt::join(names, ", "))};
}

/// Holds all devices of the section open for the program's lifetime.
Result<void> keep_open(const scene::CfgSection& section, Site& site) {
  for (const scene::DeviceAddress& provided : section.addresses("provides")) {
    const Result<device::Address> address = site.resolve(provided);
    if (!address) return Error{section.at("provides"), address.error().text};
    const auto device = site.find(*address);
    if (!device) continue;
    if (const Result<void> held = site.surroundings().hold(*device, nullptr); !held) {
      return Error{section.at("alwayson"), held.error().text};
    }
  }
  return {};
}

}  // namespace

Result<std::vector<std::unique_ptr<device::Driver>>> make_drivers(const scene::CfgFile& file, Site& site) {
  std::vector<std::unique_ptr<device::Driver>> drivers;
  for (const scene::CfgSection& section : file.drivers) {
    Result<std::unique_ptr<device::Driver>> driver = make_driver(section, site);
    if (!driver) return driver.error();
    drivers.push_back(std::move(*driver));
    if (const Result<void> fault = section.fault(); !fault) return fault.error();
  }
  Result<std::vector<std::unique_ptr<device::Driver>>> remote = make_remote_devices(site);
  if (!remote) return remote.error();
  std::ranges::move(*remote, std::back_inserter(drivers));
  if (const Result<void> finished = site.finish(); !finished) return finished.error();
  for (const scene::CfgSection& section : file.drivers) {
    if (section.flag("alwayson", false)) {
      if (const Result<void> open = keep_open(section, site); !open) return open.error();
    }
    for (const std::string& line : section.unread()) site.warn(line);
  }
  if (site.device_count() == 0) return Error{file.path, "no driver of this file provides a device"};
  return drivers;
}

}  // namespace playhouse::drivers
