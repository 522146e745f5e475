#pragma once

/// Free TCP ports in a row, for programs that need several and were given no number.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "playhouse/net/network.h"

namespace playhouse::app {

inline constexpr std::uint32_t kLastPort = 65535;

/// Listens on `count` consecutive ports, in order, and closes whatever connects, until they are destroyed: so no other
/// program can take them. Empty if there are none. `bind` as in net::Network::listen.
std::vector<std::unique_ptr<net::Listener>> hold_free_ports(net::Network& network, const std::string& bind,
                                                            std::size_t count);

}  // namespace playhouse::app
