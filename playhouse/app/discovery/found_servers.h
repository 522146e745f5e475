#pragma once

/// Servers that are announced on the local network, for commands that are told a name or nothing at all.

#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/discovery/browse.h"
#include "playhouse_client/client.h"

namespace playhouse::app {

/// "HOST", "HOST:PORT", as parse_server(); or the name of an announced server or robot, if it is no host.
Result<client::Address> reach_server(const std::string& text);

/// The server that announces a robot of this name; this machine's, if none does. Fails if several do.
Result<client::Address> server_of_robot(const std::string& robot);

/// All servers, a line each.
int list_servers(bool json);
void print_servers(const std::vector<discovery::FoundServer>& servers, bool json);

/// Those that are announced; fails without an Avahi daemon.
Result<std::vector<discovery::FoundServer>> announced_servers();

}  // namespace playhouse::app
