#pragma once

/// Devices named in a section of a configuration file, for drivers
/// that need exactly one device for each of some interfaces.

#include <initializer_list>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/device/address.h"
#include "playhouse/drivers/site.h"
#include "playhouse/scene/cfg.h"

namespace playhouse::drivers {

/// The devices of field `key` ("provides", "requires"), one for each of the interfaces, in
/// their order rather than the file's. Fails with "file:line" if the field names anything else.
Result<std::vector<device::Address>> section_devices(const scene::CfgSection& section, const Site& site,
                                                     std::string_view key,
                                                     std::initializer_list<std::string_view> interfaces);

}  // namespace playhouse::drivers
