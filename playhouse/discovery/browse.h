#pragma once

/// Asks the local network by DNS-SD which Player servers there are, through this machine's Avahi daemon.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/discovery/texts.h"

namespace playhouse::discovery {

inline constexpr std::size_t kMostServers = 256;  // others are left out

/// As somebody announces it: untrusted.
struct FoundServer {
  std::string name;
  std::string address;  // IPv4, if it has one
  std::uint16_t port = 0;
  ServerTexts texts;
};

/// In the order of their names. Waits until the daemon has asked, for `seconds` at most. Fails if there is no daemon.
Result<std::vector<FoundServer>> browse(double seconds);

}  // namespace playhouse::discovery
