#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "playhouse/base/result.h"

namespace playhouse::scene {

/// A device as configuration files write it: `key:host:port:interface:index`, where everything before the
/// interface may be left out or empty.
struct DeviceAddress {
  std::string key;                    // "": none
  std::string host;                   // "": this server
  std::optional<std::uint16_t> port;  // none: the server's own
  std::string interf;                 // interface name, e.g. "position2d"
  std::uint16_t index = 0;

  /// The same text again, the shortest form.
  std::string text() const;
  friend bool operator==(const DeviceAddress&, const DeviceAddress&) = default;
};

/// Fails with a text that quotes the address; the caller adds file and line.
Result<DeviceAddress> parse_device_address(std::string_view text);

}  // namespace playhouse::scene
