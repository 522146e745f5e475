#pragma once

/// The simulator's models by name, and the devices that represent them (docs/drivers.md).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace playhouse::client {

/// Address of a device. `port` is its name space: the TCP port as the server numbers it.
struct DeviceAddress {
  std::uint32_t port = 0;
  std::uint16_t interf = 0;  // interface code
  std::uint16_t index = 0;

  /// "position2d:0"; the numeric code if the interface is unknown.
  std::string name() const;
  friend auto operator<=>(const DeviceAddress&, const DeviceAddress&) = default;
};

/// A model of the simulated world.
struct Model {
  std::string name;                    // in full: "guest.ranger:0"
  std::string type;                    // base type after macro expansion: "position"
  std::optional<std::size_t> parent;   // row in the model list, before this one; none at the top
  std::vector<DeviceAddress> devices;  // that represent it, on all ports of the server
};

}  // namespace playhouse::client
