#include "playhouse/drivers/hardware/offered.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>

#include "playhouse/base/in_quotes.h"

namespace playhouse::drivers {
namespace {

std::string as_words(std::span<const DeviceText> offered) {
  std::vector<std::string> words;
  for (const DeviceText& device : offered)
    words.push_back(device.key.empty() ? std::string(device.interf)
                                       : fmt::format("{}:::{}", device.key, device.interf));
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

Result<std::vector<std::optional<device::Address>>> offered_devices(const config::CfgSection& section,
                                                                    const Site& site, std::string_view key,
                                                                    std::span<const DeviceText> offered) {
  std::vector<std::optional<device::Address>> places(offered.size());
  const std::vector<config::DeviceAddress> named = section.addresses(key);
  for (const config::DeviceAddress& name : named) {
    const Result<device::Address> address = site.resolve(name);
    if (!address) return Error{section.at(key), address.error().text};
    std::size_t place = 0;
    const auto fits = [&](const DeviceText& device) {
      return device.interf == name.interf && (name.key.empty() || device.key == name.key);
    };
    while (place < offered.size() && (places[place] || !fits(offered[place]))) ++place;
    if (place == offered.size())
      return Error{section.at(key),
                   fmt::format("driver {} {} no such device as {}; it has {}", in_quotes(section.name()), key,
                               in_quotes(name.text()), as_words(offered))};
    places[place] = *address;
  }
  if (named.empty())
    return Error{section.at(key), fmt::format("driver {} {} some of {}{}", in_quotes(section.name()), key,
                                              as_words(offered), section.slip_for(key))};
  return places;
}

}  // namespace playhouse::drivers
