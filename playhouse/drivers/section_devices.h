#pragma once

/// Devices named in a section of a configuration file, for drivers that need certain ones.

#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device/address.h"
#include "playhouse/drivers/site.h"

namespace playhouse::drivers {

/// A device that a driver needs.
struct WantedDevice {
  std::string_view interf;
  /// Tells devices of one interface apart, as in "output:::position2d:0"; empty: any key.
  std::string_view key = {};
  /// In errors; empty: as the interface.
  std::string_view called = {};
};

/// The devices of field `key` ("provides", "requires"), one for each wanted one, in their
/// order rather than the file's. Fails with "file:line" if the field names anything else.
Result<std::vector<device::Address>> section_devices(const config::CfgSection& section, const Site& site,
                                                     std::string_view key,
                                                     std::span<const WantedDevice> wanted);
Result<std::vector<device::Address>> section_devices(const config::CfgSection& section, const Site& site,
                                                     std::string_view key,
                                                     std::initializer_list<std::string_view> interfaces);

/// True if the field names a device of the interface, for devices that a driver may do without.
bool names_device(const config::CfgSection& section, std::string_view key, std::string_view interf);

}  // namespace playhouse::drivers
