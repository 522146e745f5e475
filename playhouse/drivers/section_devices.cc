#include "playhouse/drivers/section_devices.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"

namespace playhouse::drivers {
namespace {

using Named = std::span<const config::DeviceAddress>;
using Wanted = std::span<const WantedDevice>;

/// Suggestion for an address with a misspelt interface.
std::string hint(Named addresses, Wanted wanted) {
  std::vector<std::string_view> words;
  for (const WantedDevice& device : wanted) words.push_back(device.interf);
  for (const config::DeviceAddress& address : addresses) {
    if (std::ranges::find(words, address.interf) != words.end()) continue;
    if (const std::string meant = did_you_mean(address.interf, words); !meant.empty())
      return ", found " + in_quotes(address.text()) + meant;
  }
  return {};
}

/// E.g.: driver "vfh" requires one position2d and one laser, e.g. ["position2d:0" "laser:0"]
std::string what_is_wanted(const config::CfgSection& section, std::string_view key, Wanted wanted) {
  std::vector<std::string> words, example;
  for (const WantedDevice& device : wanted) {
    const bool has_key = !device.key.empty();
    words.push_back(fmt::format("one {}{}", device.called.empty() ? device.interf : device.called,
                                has_key ? fmt::format(" of key {}", device.key) : ""));
    example.push_back(
        fmt::format("\"{}{}:0\"", has_key ? fmt::format("{}:::", device.key) : "", device.interf));
  }
  return fmt::format("driver {} {} {}, e.g. [{}]", in_quotes(section.name()), key, fmt::join(words, " and "),
                     fmt::join(example, " "));
}

/// Index of the address that stands for a wanted device; none if there is none.
std::optional<std::size_t> find(Named named, const WantedDevice& wanted) {
  for (std::size_t i = 0; i < named.size(); ++i)
    if (named[i].interf == wanted.interf && (wanted.key.empty() || named[i].key == wanted.key)) return i;
  return std::nullopt;
}

}  // namespace

Result<std::vector<device::Address>> section_devices(const config::CfgSection& section, const Site& site,
                                                     std::string_view key, Wanted wanted) {
  const std::vector<config::DeviceAddress> named = section.addresses(key);
  std::vector<device::Address> devices;
  for (const WantedDevice& device : wanted) {
    const std::optional<std::size_t> found = find(named, device);
    if (!found || named.size() != wanted.size()) {
      return Error{section.at(key),
                   what_is_wanted(section, key, wanted) + hint(named, wanted) + section.slip_for(key)};
    }
    const Result<device::Address> address = site.resolve(named[*found]);
    if (!address) return Error{section.at(key), address.error().text};
    devices.push_back(*address);
  }
  return devices;
}

Result<std::vector<device::Address>> section_devices(const config::CfgSection& section, const Site& site,
                                                     std::string_view key,
                                                     std::initializer_list<std::string_view> interfaces) {
  std::vector<WantedDevice> wanted;
  for (const std::string_view interf : interfaces) wanted.push_back({interf});
  return section_devices(section, site, key, wanted);
}

bool names_device(const config::CfgSection& section, std::string_view key, std::string_view interf) {
  const std::vector<config::DeviceAddress> named = section.addresses(key);
  return std::ranges::find(named, interf, &config::DeviceAddress::interf) != named.end();
}

}  // namespace playhouse::drivers
