#pragma once

/// What is told of a driver of configuration files (`playhouse drivers`), beside the code that it tells of.

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/section_fields.h"
#include "playhouse/drivers/site.h"

namespace playhouse::drivers {

/// How many devices of its kind a section names.
enum class HowMany : std::uint8_t { kOne, kOneOrNone, kAny, kOneOfThese, kSomeOfThese, kOneOfTheseOrNone };

/// True of devices that stand for each other.
inline bool is_alternative(HowMany many) {
  return many == HowMany::kOneOfThese || many == HowMany::kSomeOfThese || many == HowMany::kOneOfTheseOrNone;
}

/// Devices that a section provides or requires.
struct DeviceText {
  std::string_view interf;  // empty: any
  std::string_view key = {};
  HowMany many = HowMany::kOne;
  std::string_view doc = {};
};

/// A property of each device of a driver, beside its interface.
struct PropertyText {
  std::string_view name, type, doc;
};

struct DriverDefinition {
  std::string_view name;
  std::string_view doc;              // one sentence
  std::string_view other_name = {};  // the same driver
  std::span<const DeviceText> provides;
  std::span<const DeviceText> uses = {};
  std::span<const PropertyText> properties = {};
  /// Reads all options, by the function that the driver reads them by; null: it has none.
  void (*read_options)(SectionFields) = nullptr;
  /// Makes the driver of a section and registers its devices. Errors carry "file:line".
  Result<std::unique_ptr<device::Driver>> (*make)(const config::CfgSection&, Site&);
  /// Makes what relays the devices that drivers of a file require of other servers (Site::take_remote_devices());
  /// null: another driver does that.
  Result<std::vector<std::unique_ptr<device::Driver>>> (*make_remote)(Site&) = nullptr;
};

/// The `read_options` of a function that returns them.
template <auto kRead>
void reading(SectionFields fields) {
  static_cast<void>(kRead(fields));
}

/// The options of a driver, in the order in which it reads them.
std::vector<Option> options_of(const DriverDefinition& driver);

}  // namespace playhouse::drivers
