#pragma once

/// How devices and servers are named on the command line.

#include <cstdint>
#include <optional>
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

/// A device on the command line: its address, or a model that shows it.
struct WantedDevice {
  std::optional<DeviceName> address;
  std::string model;  // where there is no address
};

/// What has the form of an address fails with the nearest interface name; what has not is a model's name.
Result<WantedDevice> parse_wanted_device(const std::string& text);

/// The address itself, or the first device of the model, and then of what it carries, whose interface
/// `fits`. Fails where the server knows no such model, tells no names, or the model has no such device.
Result<DeviceName> find_device(client::Client& client, const WantedDevice& wanted,
                               bool (*fits)(std::uint16_t interf));

/// "HOST", "HOST:PORT", "" for this machine; a number alone is a port of this machine, for no host has such a
/// name. `port` is that of a host alone.
Result<client::Address> parse_server(const std::string& text, std::uint16_t port = client::kDefaultPort);

}  // namespace playhouse::app
