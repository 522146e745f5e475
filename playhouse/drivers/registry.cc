#include "playhouse/drivers/registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/drivers/amcl/amcl.h"
#include "playhouse/drivers/dummy/dummy.h"
#include "playhouse/drivers/health/health.h"
#include "playhouse/drivers/localbb/local_blackboard.h"
#include "playhouse/drivers/mapfile/map_file.h"
#include "playhouse/drivers/nd/nd.h"
#include "playhouse/drivers/passthrough/passthrough.h"
#include "playhouse/drivers/plugin/plugin_shell.h"
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
    {"dummy", make_dummy},
    {"health", make_health},
    {"localbb", make_local_blackboard},
    {"mapfile", make_map_file},
    {"nd", make_nd},
    {"passthrough", make_passthrough},
    {"rangertolaser", make_ranger_to_laser},
    {"relay", make_relay},
    {"stage", make_stage_driver},
    {"statgrabdriver", make_health},
    {"vfh", make_vfh},
    {"wavefront", make_wavefront},
};

/// What does instead of a driver of Player that this program does not have.
constexpr std::pair<std::string_view, std::string_view> kInstead[] = {
    {"readlog", "; \"playhouse replay\" shows a recording"},
    {"writelog", "; the option --record records a run"},
};

/// That of a section: a driver of the program, or the plug-in that the section names; null if there is neither.
Factory factory_of(const scene::CfgSection& section) {
  const auto found =
      std::ranges::find(kDrivers, section.name(), &std::pair<std::string_view, Factory>::first);
  if (found != std::end(kDrivers)) return found->second;
  return section.has("plugin") ? make_plugin : nullptr;
}

std::string no_such_driver(const std::string& name) {
  std::vector<std::string_view> names;
  for (const auto& [known, make] : kDrivers) names.push_back(known);
  const auto instead =
      std::ranges::find(kInstead, name, &std::pair<std::string_view, std::string_view>::first);
  if (instead != std::end(kInstead)) return fmt::format("this program has no such driver{}", instead->second);
  return fmt::format("this program has no such driver{}; it has {}", did_you_mean(name, names),
                     fmt::join(names, ", "));
}

/// The addresses of a field that can be resolved.
std::vector<device::Address> devices_of(const scene::CfgSection& section, std::string_view key,
                                        const Site& site) {
  std::vector<device::Address> devices;
  for (const scene::DeviceAddress& named : section.addresses(key))
    if (const Result<device::Address> address = site.resolve(named)) devices.push_back(*address);
  return devices;
}

/// The sections to make: those of known drivers whose required devices are not those of sections that are
/// left out. A warning for each of the others, so that one driver that we lack does not keep a file from
/// running.
std::vector<const scene::CfgSection*> sections_to_make(const scene::CfgFile& file, Site& site) {
  std::vector<const scene::CfgSection*> kept;
  std::map<device::Address, std::string> lacking;  // devices of sections left out, and where these are
  const auto leave_out = [&](const scene::CfgSection& section, const std::string& why) {
    site.warn(
        fmt::format("{}: driver {} is left out: {}", section.at("name"), in_quotes(section.name()), why));
    for (const device::Address& device : devices_of(section, "provides", site))
      lacking[device] = section.at();
  };
  for (const scene::CfgSection& section : file.drivers) {
    if (factory_of(section) != nullptr)
      kept.push_back(&section);
    else
      leave_out(section, no_such_driver(section.name()));
  }
  const auto lacks_one = [&](const scene::CfgSection* section) {
    for (const device::Address& device : devices_of(*section, "requires", site)) {
      const auto found = lacking.find(device);
      if (found == lacking.end()) continue;
      leave_out(*section, fmt::format("it requires {}, which {} would provide", in_quotes(site.shown(device)),
                                      found->second));
      return true;
    }
    return false;
  };
  while (std::erase_if(kept, lacks_one) > 0) continue;
  return kept;
}

/// Keeps all devices of the section open for the program's lifetime.
Result<void> keep_open(const scene::CfgSection& section, device::Driver& driver, Site& site) {
  std::vector<device::DeviceId> devices;
  for (const scene::DeviceAddress& provided : section.addresses("provides")) {
    const Result<device::Address> address = site.resolve(provided);
    if (!address) return Error{section.at("provides"), address.error().text};
    if (const auto device = site.find(*address)) devices.push_back(*device);
  }
  const Result<void> begun = site.keep_open(
      driver, std::move(devices), fmt::format("{}: driver {}", section.at(), in_quotes(section.name())));
  return begun ? begun : Error{section.at("alwayson"), begun.error().text};
}

}  // namespace

Result<std::vector<std::unique_ptr<device::Driver>>> make_drivers(const scene::CfgFile& file, Site& site) {
  std::vector<std::unique_ptr<device::Driver>> drivers;
  const auto is_known = [](const scene::CfgSection& section) { return factory_of(section) != nullptr; };
  if (std::ranges::none_of(file.drivers, is_known)) {
    const scene::CfgSection& first = file.drivers.front();
    return Error{first.at("name"),
                 fmt::format("driver {}: {}", in_quotes(first.name()), no_such_driver(first.name()))};
  }
  const std::vector<const scene::CfgSection*> sections = sections_to_make(file, site);
  for (const scene::CfgSection* section : sections) {
    Result<std::unique_ptr<device::Driver>> driver = factory_of(*section)(*section, site);
    if (!driver) return driver.error();
    drivers.push_back(std::move(*driver));
    if (const Result<void> fault = section->fault(); !fault) return fault.error();
  }
  Result<std::vector<std::unique_ptr<device::Driver>>> remote = make_remote_devices(site);
  if (!remote) return remote.error();
  std::ranges::move(*remote, std::back_inserter(drivers));
  if (const Result<void> finished = site.finish(); !finished) return finished.error();
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const scene::CfgSection& section = *sections[i];
    if (section.flag("alwayson", false)) {
      if (const Result<void> open = keep_open(section, *drivers[i], site); !open) return open.error();
    }
    for (const std::string& line : section.unread()) site.warn(line);
  }
  if (site.device_count() == 0) return Error{file.path, "no driver of this file provides a device"};
  return drivers;
}

}  // namespace playhouse::drivers
