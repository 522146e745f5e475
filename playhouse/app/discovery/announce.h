#pragma once

/// Announces a server on the local network, if others reach it (discovery/announcer.h).

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "playhouse/app/commands/options.h"
#include "playhouse/discovery/announcer.h"

namespace playhouse::app {

/// True if an address to listen on is not this machine's alone.
bool is_for_others(const std::string& bind);

/// The ports for Player clients; the robots are those of the first one. Null if nobody else reaches them.
std::unique_ptr<discovery::Announcer> announce(const Serving& serving, std::span<const std::uint16_t> ports,
                                               const std::vector<std::string>& robots);

}  // namespace playhouse::app
