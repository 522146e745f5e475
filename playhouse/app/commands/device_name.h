#pragma once

/// Names of devices and servers on the command line.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "playhouse/base/result.h"
#include "playhouse_client/client.h"

namespace playhouse::app {

/// A device like "laser:0".
struct DeviceName {
  std::uint16_t interf = 0;
  std::uint16_t index = 0;
};

/// Fails with the nearest interface name. The index defaults to 0.
Result<DeviceName> parse_device_name(std::string_view text);

/// A device on the command line: an address, or the name of its model.
struct DeviceArgument {
  std::optional<DeviceName> address;
  std::string model;  // if there is no address
};

/// Text in the form of an address fails with the nearest interface name; other text is a model name.
Result<DeviceArgument> parse_wanted_device(const std::string& text);

/// The address itself, or the first device of the model, otherwise of its parts, whose interface
/// `fits`. Fails if the server does not know the model or has no names, or if there is no such device.
Result<DeviceName> find_device(client::Client& client, const DeviceArgument& wanted,
                               bool (*fits)(std::uint16_t interf));

/// Parses "HOST", "HOST:PORT", "" for localhost; a number
/// alone is a port on localhost. `port` is the default.
Result<client::Address> parse_server(const std::string& text, std::uint16_t port = client::kDefaultPort);

}  // namespace playhouse::app
