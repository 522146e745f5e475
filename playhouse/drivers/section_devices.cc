#include "playhouse/drivers/section_devices.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"

namespace playhouse::drivers {
namespace {

using Words = std::span<const std::string_view>;

/// Suggestion for an address with a misspelt interface.
std::string hint(std::span<const scene::DeviceAddress> addresses, Words wanted) {
  for (const scene::DeviceAddress& address : addresses) {
    if (std::ranges::find(wanted, address.interf) != wanted.end()) continue;
    if (const std::string meant = did_you_mean(address.interf, wanted); !meant.empty())
      return ", found " + in_quotes(address.text()) + meant;
  }
  return {};
}

/// E.g.: driver "vfh" requires one position2d and one laser, e.g. ["position2d:0" "laser:0"]
std::string what_is_wanted(const scene::CfgSection& section, std::string_view key, Words interfaces) {
  std::vector<std::string> wanted, example;
  for (const std::string_view interf : interfaces) {
    wanted.push_back(fmt::format("one {}", interf));
    example.push_back(fmt::format("\"{}:0\"", interf));
  }
  return fmt::format("driver {} {} {}, e.g. [{}]", in_quotes(section.name()), key, fmt::join(wanted, " and "),
                     fmt::join(example, " "));
}

}  // namespace

Result<std::vector<device::Address>> section_devices(const scene::CfgSection& section, const Site& site,
                                                     std::string_view key,
                                                     std::initializer_list<std::string_view> interfaces) {
  const std::vector<scene::DeviceAddress> named = section.addresses(key);
  std::vector<device::Address> devices;
  for (const std::string_view interf : interfaces) {
    const auto found = std::ranges::find(named, interf, &scene::DeviceAddress::interf);
    if (found == named.end() || named.size() != interfaces.size()) {
      return Error{section.at(key), what_is_wanted(section, key, interfaces) + hint(named, interfaces) +
                                        section.slip_for(key)};
    }
    const Result<device::Address> device = site.resolve(*found);
    if (!device) return Error{section.at(key), device.error().text};
    devices.push_back(*device);
  }
  return devices;
}

}  // namespace playhouse::drivers
