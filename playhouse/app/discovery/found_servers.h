#pragma once

/// Servers that are announced on the local network, for commands that are told a name or nothing at all.

#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/discovery/browse.h"
#include "playhouse_client/client.h"

namespace playhouse::app {

/// A server for a command to connect to.
struct NamedServer {
  client::Address address;
  std::string
      not_announced;  // of a name that no server announces: what to say where nobody answers; else empty

  /// The error of connecting.
  Error explain(const Error& why) const;
};

/// "HOST", "HOST:PORT", as parse_server(); or the name of an announced server or robot, if it is no host.
Result<NamedServer> reach_server(const std::string& text);

/// The server that announces a robot of this name; this machine's, if none does. Fails if several do.
Result<NamedServer> server_of_robot(const std::string& robot);

/// `none`, that nobody was found, with the reason where the network could not be asked.
std::string and_of_network(std::string none, const Result<std::vector<discovery::FoundServer>>& servers);

/// All servers, a line each.
int list_servers(bool json);
void print_servers(const std::vector<discovery::FoundServer>& servers, bool json);

/// Those that are announced; fails without an Avahi daemon.
Result<std::vector<discovery::FoundServer>> announced_servers();

}  // namespace playhouse::app
