#pragma once

#include <cstdint>
#include <string_view>

#include "playhouse/base/result.h"

namespace playhouse::app {

/// "laser:0" as people type it.
struct DeviceName {
  std::uint16_t interf = 0;
  std::uint16_t index = 0;
};

/// Fails with the nearest interface name. A name without an index means index 0.
Result<DeviceName> parse_device_name(std::string_view text);

}  // namespace playhouse::app
