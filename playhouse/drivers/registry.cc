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

namespace playhouse::drivers {
namespace {

/// The addresses of a field that can be resolved.
std::vector<device::Address> devices_of(const config::CfgSection& section, std::string_view key,
                                        const Site& site) {
  std::vector<device::Address> devices;
  for (const config::DeviceAddress& named : section.addresses(key))
    if (const Result<device::Address> address = site.resolve(named)) devices.push_back(*address);
  return devices;
}

/// Keeps all devices of the section open for the program's lifetime.
Result<void> keep_open(const config::CfgSection& section, device::Driver& driver, Site& site) {
  std::vector<device::DeviceId> devices;
  for (const config::DeviceAddress& provided : section.addresses("provides")) {
    const Result<device::Address> address = site.resolve(provided);
    if (!address) return Error{section.at("provides"), address.error().text};
    if (const auto device = site.find(*address)) devices.push_back(*device);
  }
  const Result<void> begun = site.keep_open(
      driver, std::move(devices), fmt::format("{}: driver {}", section.at(), in_quotes(section.name())));
  return begun ? begun : Error{section.at("alwayson"), begun.error().text};
}

}  // namespace

Registry::Registry(std::vector<const DriverDefinition*> drivers, Factory plug_in,
                   std::span<const Instead> instead)
    : drivers_(std::move(drivers)), plug_in_(plug_in), instead_(instead) {
  std::ranges::sort(drivers_, {}, &DriverDefinition::name);
}

const DriverDefinition* Registry::find(std::string_view name) const {
  const auto found = std::ranges::find_if(drivers_, [name](const DriverDefinition* driver) {
    return driver->name == name || (!name.empty() && driver->other_name == name);
  });
  return found == drivers_.end() ? nullptr : *found;
}

/// That of a section: a driver of the program, or the plug-in that the section names; null if there is neither.
Registry::Factory Registry::factory_of(const config::CfgSection& section) const {
  if (const DriverDefinition* known = find(section.name())) return known->make;
  return section.has("plugin") ? plug_in_ : nullptr;
}

std::vector<std::string_view> Registry::names() const {
  std::vector<std::string_view> names;
  for (const DriverDefinition* driver : drivers_) {
    names.push_back(driver->name);
    if (!driver->other_name.empty()) names.push_back(driver->other_name);
  }
  std::ranges::sort(names);
  return names;
}

std::string Registry::what_instead_of(std::string_view name) const {
  const std::string_view instead = what_has_its_place(name);
  return instead.empty() ? did_you_mean(name, names()) : std::string(instead);
}

/// Empty if there is nothing.
std::string_view Registry::what_has_its_place(std::string_view name) const {
  const auto found = std::ranges::find(instead_, name, &Instead::first);
  return found == instead_.end() ? std::string_view() : found->second;
}

std::string Registry::no_such_driver(const config::CfgSection& section) const {
  if (plug_in_ == nullptr && section.has("plugin")) return "this program loads no plug-ins";
  const std::string name = section.name();
  const std::string text = "this program has no such driver" + what_instead_of(name);
  return what_has_its_place(name).empty() ? fmt::format("{}; it has {}", text, fmt::join(names(), ", "))
                                          : text;
}

/// Emulators alone provide nothing.
Result<void> Registry::check_provides(const config::CfgSection& section) const {
  const DriverDefinition* const known = find(section.name());
  const bool provides_none = known != nullptr && known->provides.empty();
  if (provides_none == (section.count("provides") == 0)) return {};
  const std::string driver = "driver " + in_quotes(section.name());
  if (provides_none) return Error{section.at("provides"), driver + " provides no device"};
  return Error{section.at(), driver + " needs the devices it provides, as in: provides [ \"position2d:0\" ]" +
                                 section.slip_for("provides")};
}

/// The sections to make: those of known drivers whose required devices are not those of sections that are
/// left out. A warning for each of the others, so that one driver that we lack does not keep a file from
/// running.
std::vector<const config::CfgSection*> Registry::sections_to_make(const config::CfgFile& file,
                                                                  Site& site) const {
  std::vector<const config::CfgSection*> kept;
  std::map<device::Address, std::string> lacking;  // devices of sections left out, and where these are
  const auto leave_out = [&](const config::CfgSection& section, const std::string& why) {
    site.warn(
        fmt::format("{}: driver {} is left out: {}", section.at("name"), in_quotes(section.name()), why));
    for (const device::Address& device : devices_of(section, "provides", site))
      lacking[device] = section.at();
  };
  for (const config::CfgSection& section : file.drivers) {
    if (factory_of(section) != nullptr)
      kept.push_back(&section);
    else
      leave_out(section, no_such_driver(section));
  }
  const auto lacks_one = [&](const config::CfgSection* section) {
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

Result<std::vector<std::unique_ptr<device::Driver>>> Registry::make(const config::CfgFile& file,
                                                                    Site& site) const {
  std::vector<std::unique_ptr<device::Driver>> drivers;
  const auto is_known = [this](const config::CfgSection& section) { return factory_of(section) != nullptr; };
  if (std::ranges::none_of(file.drivers, is_known)) {
    const config::CfgSection& first = file.drivers.front();
    return Error{first.at("name"),
                 fmt::format("driver {}: {}", in_quotes(first.name()), no_such_driver(first))};
  }
  const std::vector<const config::CfgSection*> sections = sections_to_make(file, site);
  for (const config::CfgSection* section : sections) {
    if (const Result<void> provided = check_provides(*section); !provided) return provided.error();
    Result<std::unique_ptr<device::Driver>> driver = factory_of(*section)(*section, site);
    if (!driver) return driver.error();
    drivers.push_back(std::move(*driver));
    if (const Result<void> fault = section->fault(); !fault) return fault.error();
  }
  for (const DriverDefinition* driver : drivers_) {
    if (driver->make_remote == nullptr) continue;
    Result<std::vector<std::unique_ptr<device::Driver>>> remote = driver->make_remote(site);
    if (!remote) return remote.error();
    std::ranges::move(*remote, std::back_inserter(drivers));
  }
  if (const Result<void> finished = site.finish(); !finished) return finished.error();
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const config::CfgSection& section = *sections[i];
    if (section.flag("alwayson", false)) {
      if (const Result<void> open = keep_open(section, *drivers[i], site); !open) return open.error();
    }
    for (const std::string& line : section.unread()) site.warn(line);
  }
  if (site.device_count() == 0) return Error{file.path, "no driver of this file provides a device"};
  return drivers;
}

}  // namespace playhouse::drivers
