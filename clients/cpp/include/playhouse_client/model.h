#pragma once

/// What a simulator calls its models, and which devices show them (docs/drivers.md).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace playhouse::client {

/// Where a device is. `port` is the name space: the TCP port as the server knows it.
struct DeviceAddress {
  std::uint32_t port = 0;
  std::uint16_t interf = 0;  // interface code
  std::uint16_t index = 0;

  /// "position2d:0"; the code where the interface has no known name.
  std::string name() const;
  friend auto operator<=>(const DeviceAddress&, const DeviceAddress&) = default;
};

/// A model of the simulated world.
struct Model {
  std::string name;                    // in full: "guest.ranger:0"
  std::string type;                    // whatever macro made it: "position"
  std::optional<std::size_t> parent;   // its place in the list of models, before this one; none at the top
  std::vector<DeviceAddress> devices;  // that show it, on all ports of the server
};

}  // namespace playhouse::client
