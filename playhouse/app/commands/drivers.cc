#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "playhouse/app/commands/commands.h"
#include "playhouse/app/commands/json_or_null.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/bridge/all_drivers.h"

namespace playhouse::app {
namespace {

using drivers::DeviceText;
using drivers::DriverDefinition;
using drivers::HowMany;
using drivers::Option;
using drivers::PropertyText;

constexpr std::array<std::string_view, 6> kHowMany = {
    "one", "optional", "one or more", "one of these", "some of these", "one of these or none"};

std::string_view name_of(HowMany many) {
  return kHowMany.at(static_cast<std::size_t>(many));
}

std::string json_of(const DeviceText& device) {
  return fmt::format(R"({{"interface":{},"key":{},"many":{},"doc":{}}})", json_or_null(device.interf),
                     json_or_null(device.key), json_or_null(name_of(device.many)), json_or_null(device.doc));
}

std::string json_of(const Option& option) {
  return fmt::format(
      R"({{"name":{},"type":{},"unit":{},"default":{},"default_told":{},"limits":{},"doc":{}}})",
      json_or_null(option.name), json_or_null(option.type), json_or_null(option.unit),
      json_or_null(option.otherwise), json_or_null(option.told), json_or_null(option.limits),
      json_or_null(option.doc));
}

std::string json_of(const PropertyText& property) {
  return fmt::format(R"({{"name":{},"type":{},"doc":{}}})", json_or_null(property.name),
                     json_or_null(property.type), json_or_null(property.doc));
}

void print_json(const DriverDefinition& driver) {
  const auto write = [](const auto& item) { return json_of(item); };
  fmt::print(
      R"({{"name":{},"other_name":{},"doc":{},"provides":{},"requires":{},"options":{},"properties":{}}})"
      "\n",
      json_or_null(driver.name), json_or_null(driver.other_name), json_or_null(driver.doc),
      json_list(driver.provides, write), json_list(driver.uses, write),
      json_list(drivers::options_of(driver), write), json_list(driver.properties, write));
}

/// As in a file, but for the index: "input:::position2d".
std::string shown(const DeviceText& device) {
  if (device.interf.empty()) return "any interface";
  return device.key.empty() ? std::string(device.interf) : fmt::format("{}:::{}", device.key, device.interf);
}

/// "input:::position2d, laser or sonar".
std::string in_short(std::span<const DeviceText> devices) {
  std::string text;
  bool was_alternative = false;
  for (const DeviceText& device : devices) {
    if (!text.empty()) text += was_alternative && is_alternative(device.many) ? " or " : ", ";
    text += shown(device);
    was_alternative = is_alternative(device.many);
  }
  return text;
}

void print_line(const DriverDefinition& driver) {
  fmt::print("{:<14} {} Provides {}", driver.name, driver.doc, in_short(driver.provides));
  fmt::print("{}.\n", driver.uses.empty() ? "" : "; requires " + in_short(driver.uses));
  if (!driver.other_name.empty()) fmt::print("{:<14} The same as {}.\n", driver.other_name, driver.name);
}

void print_devices(std::string_view title, std::span<const DeviceText> devices) {
  for (const DeviceText& device : devices) {
    const std::string many = device.many == HowMany::kOne ? "" : fmt::format(", {}", name_of(device.many));
    fmt::print("  {} {}{}{}\n", title, shown(device), many,
               device.doc.empty() ? "" : fmt::format(": {}", device.doc));
  }
}

std::string meaning_of(const Option& option) {
  std::string text = option.doc;
  if (!option.limits.empty()) text += fmt::format(" Limits: {}.", option.limits);
  const std::string& otherwise = option.otherwise.empty() ? option.told : option.otherwise;
  return otherwise.empty() ? text : fmt::format("{} Default: {}.", text, otherwise);
}

void print_option(const Option& option, std::size_t width) {
  if (option.type.empty()) {
    fmt::print("  {:<{}} no effect. {}\n", option.name, width, option.doc);
    return;
  }
  fmt::print("  {:<{}} {}{}\n  {:<{}} {}\n", option.name, width, option.type,
             option.unit.empty() ? "" : fmt::format(" ({})", option.unit), "", width, meaning_of(option));
}

void print_page(const DriverDefinition& driver) {
  fmt::print("{}{}: {}\n", driver.name,
             driver.other_name.empty() ? "" : fmt::format(" ({})", driver.other_name), driver.doc);
  print_devices("provides", driver.provides);
  print_devices("requires", driver.uses);
  const std::vector<Option> options = drivers::options_of(driver);
  std::size_t width = 0;
  for (const Option& option : options) width = std::max(width, option.name.size());
  if (!options.empty()) fmt::print("\nOptions:\n");
  for (const Option& option : options) print_option(option, width);
  if (!driver.properties.empty()) fmt::print("\nProperties of its devices:\n");
  for (const PropertyText& property : driver.properties)
    fmt::print("  {} ({}): {}\n", property.name, property.type, property.doc);
  fmt::print(
      "\nEvery section has name and provides, and may have requires and alwayson (docs/drivers.md); one\n"
      "of a shared library has plugin, and may have isolated (docs/plugins.md).\n");
}

}  // namespace

int drivers(const DriversOptions& options) {
  if (options.name.empty()) {
    for (const DriverDefinition* driver : drivers::all_drivers().all())
      options.json ? print_json(*driver) : print_line(*driver);
    return kDone;
  }
  const DriverDefinition* driver = drivers::all_drivers().find(options.name);
  if (driver == nullptr) {
    return fail({"", fmt::format("unknown driver {}{}; playhouse drivers lists all", in_quotes(options.name),
                                 drivers::all_drivers().what_instead_of(options.name))},
                kUsage);
  }
  options.json ? print_json(*driver) : print_page(*driver);
  return kDone;
}

}  // namespace playhouse::app
