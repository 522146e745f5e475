#pragma once

/// Devices of a section among those that a driver offers or may use: any of them, each once, told apart by interface and key.

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device/address.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/site.h"

namespace playhouse::drivers {

/// Where each of `offered` is, in that order; none: the section does not name it. One of an interface is the first that is
/// not taken, if its key is that of the offered device or the section gives none. Fails with "file:line" if the field
/// names another device, or none at all.
Result<std::vector<std::optional<device::Address>>> offered_devices(const config::CfgSection& section,
                                                                    const Site& site, std::string_view key,
                                                                    std::span<const DeviceText> offered);

}  // namespace playhouse::drivers
