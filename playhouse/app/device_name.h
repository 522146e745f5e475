#pragma once

/// How devices and servers are named on the command line.

#include <cstdint>
#include <string>
#include <string_view>

#include "playhouse/base/result.h"
#include "playhouse_client/client.h"

namespace playhouse::app {

/// "laser:0" as people type it.
struct DeviceName {
  std::uint16_t interf = 0;
  std::uint16_t index = 0;
};

/// Fails with the nearest interface name. A name without an index means index 0.
Result<DeviceName> parse_device_name(std::string_view text);

/// "HOST", "HOST:PORT", "" for this machine; a number alone is a port of this machine, for no host has such a
/// name.
Result<client::Address> parse_server(const std::string& text);

}  // namespace playhouse::app
