#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "playhouse/base/result.h"

namespace playhouse::config {

/// A device address in configuration files: `key:host:port:interface:index`;
/// everything before the interface may be missing or empty. An IPv6 host is in brackets.
struct DeviceAddress {
  std::string key;                    // "": none
  std::string host;                   // "": this server; "::1"; "/FOLDER": one with a Unix socket there
  std::optional<std::uint16_t> port;  // none: the server's own
  std::string interf;                 // interface name, e.g. "position2d"
  std::uint16_t index = 0;

  /// The shortest text that parses to this address.
  std::string text() const;
  friend bool operator==(const DeviceAddress&, const DeviceAddress&) = default;
};

/// Fails with a message that quotes the address; the caller adds file and line.
Result<DeviceAddress> parse_device_address(std::string_view text);

}  // namespace playhouse::config
