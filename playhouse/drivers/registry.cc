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
#include "playhouse/drivers/amcl/amcl_options.h"
#include "playhouse/drivers/dummy/dummy.h"
#include "playhouse/drivers/health/health.h"
#include "playhouse/drivers/localbb/local_blackboard.h"
#include "playhouse/drivers/mapfile/map_file.h"
#include "playhouse/drivers/nd/nd_options.h"
#include "playhouse/drivers/passthrough/passthrough.h"
#include "playhouse/drivers/plugin/plugin_shell.h"
#include "playhouse/drivers/rangertolaser/ranger_to_laser.h"
#include "playhouse/drivers/relay/relay.h"
#include "playhouse/drivers/stage_driver/stage_driver.h"
#include "playhouse/drivers/vfh/vfh_options.h"
#include "playhouse/drivers/wavefront/wavefront_options.h"

namespace playhouse::drivers {
namespace {

/// All drivers, by name.
constexpr const DriverDefinition* kDrivers[] = {
    &kAmclDriver,    &kDummyDriver, &kHealthDriver,      &kLocalBlackboardDriver,
    &kMapFileDriver, &kNdDriver,    &kPassthroughDriver, &kRangerToLaserDriver,
    &kRelayDriver,   &kStageDriver, &kVfhDriver,         &kWavefrontDriver,
};

using Factory = decltype(DriverDefinition::make);

/// What does instead of a driver of Player that this program does not have.
constexpr std::pair<std::string_view, std::string_view> kInstead[] = {
    {"readlog", "; \"playhouse replay\" shows a recording"},
    {"writelog", "; the option --record records a run"},
};

constexpr const char* kDriversOfProgram = R"(
driver ( name "localbb" provides ["blackboard:0"] )
driver ( name "health" provides ["health:0"] )
)";

/// That of a section: a driver of the program, or the plug-in that the section names; null if there is neither.
Factory factory_of(const scene::CfgSection& section) {
  if (const DriverDefinition* known = find_driver(section.name())) return known->make;
  return section.has("plugin") ? make_plugin : nullptr;
}

/// Empty if there is nothing.
std::string_view what_has_its_place(std::string_view name) {
  const auto found = std::ranges::find(kInstead, name, &std::pair<std::string_view, std::string_view>::first);
  return found == std::end(kInstead) ? std::string_view() : found->second;
}

std::vector<std::string_view> all_names() {
  std::vector<std::string_view> names;
  for (const DriverDefinition* driver : kDrivers) {
    names.push_back(driver->name);
    if (!driver->other_name.empty()) names.push_back(driver->other_name);
  }
  std::ranges::sort(names);
  return names;
}

std::string no_such_driver(const std::string& name) {
  const std::string text = "this program has no such driver" + what_instead_of_driver(name);
  return what_has_its_place(name).empty() ? fmt::format("{}; it has {}", text, fmt::join(all_names(), ", "))
                                          : text;
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

std::span<const DriverDefinition* const> driver_definitions() {
  return kDrivers;
}

const DriverDefinition* find_driver(std::string_view name) {
  const auto found = std::ranges::find_if(kDrivers, [name](const DriverDefinition* driver) {
    return driver->name == name || (!name.empty() && driver->other_name == name);
  });
  return found == std::end(kDrivers) ? nullptr : *found;
}

std::string what_instead_of_driver(std::string_view name) {
  const std::string_view instead = what_has_its_place(name);
  return instead.empty() ? did_you_mean(name, all_names()) : std::string(instead);
}

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

Result<std::vector<std::unique_ptr<device::Driver>>> make_drivers_of_program(Site& site) {
  scene::MemoryFiles none({});
  const Result<scene::CfgFile> file = scene::load_cfg_text(kDriversOfProgram, "drivers of the program", none);
  return file ? make_drivers(*file, site) : file.error();
}

}  // namespace playhouse::drivers
