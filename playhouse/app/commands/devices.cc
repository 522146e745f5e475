#include <fmt/format.h>

#include <algorithm>

#include "playhouse/app/commands/commands.h"
#include "playhouse/app/commands/device_name.h"
#include "playhouse/app/discovery/found_servers.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/wire/json.h"
#include "playhouse/wire/messages.h"
#include "playhouse_client/client.h"

namespace playhouse::app {
namespace {

std::string in_json(const std::string& text) {
  std::string out;
  wire::json_text(out, text);
  return out;
}

/// A text that may be missing.
std::string or_null(const std::string& text) {
  return text.empty() ? "null" : in_json(text);
}

/// {"device":"laser:0","interface":"laser","index":0,"port":6665,"driver":"stage","model":"r0.ranger:0",
/// "robot":"r0"}
void print_json(const client::DeviceEntry& device) {
  const wire::InterfaceDef* interf = wire::find_interface(device.address.interf);
  fmt::print(R"({{"device":{},"interface":{},"index":{},"port":{},"driver":{},"model":{},"robot":{}}})"
             "\n",
             in_json(device.name()), interf == nullptr ? "null" : in_json(std::string(interf->name)),
             device.address.index, device.address.port, in_json(device.driver), or_null(device.model),
             or_null(device.robot));
}

/// Width of a column, within limits.
std::size_t column(std::size_t least, std::size_t longest) {
  constexpr std::size_t kWidest = 40;
  return std::clamp(longest, least, kWidest);
}

void print_table(const std::vector<client::DeviceEntry>& devices) {
  std::size_t model = 0;
  for (const client::DeviceEntry& device : devices) model = std::max(model, device.model.size());
  for (const client::DeviceEntry& device : devices) {
    fmt::print("{:<20} ", device.name());
    if (model > 0)
      fmt::print("{:<{}} ", device.model.empty() ? "-" : escaped(device.model), column(8, model));
    fmt::print("{}\n", escaped(device.driver));  // untrusted text of a server
  }
}

/// Without a server on this machine: those of the network, if there are any.
int no_server_here(const DevicesOptions& options, const Error& why) {
  const Result<std::vector<discovery::FoundServer>> servers = announced_servers();
  if (!servers || servers->empty())
    return fail(
        {why.where, why.text + "; " + and_of_network("no server is announced on the network", servers)});
  log::info("no server on this machine; on the network there are");
  print_servers(*servers, options.json);
  return kDone;
}

}  // namespace

int devices(const DevicesOptions& options) {
  if (options.network) return list_servers(options.json);
  const Result<NamedServer> server = reach_server(options.server);
  if (!server) return fail(server.error(), kUsage);
  Result<client::Client> client =
      client::Client::connect(server->address.host, server->address.port, {.token = options.token});
  if (!client && options.server.empty()) return no_server_here(options, client.error());
  if (!client) return fail(server->explain(client.error()));
  const Result<std::vector<client::DeviceEntry>> devices = client->devices();
  if (!devices) return fail(devices.error());
  if (options.json) {
    for (const client::DeviceEntry& device : *devices) print_json(device);
  } else {
    print_table(*devices);
  }
  return kDone;
}

}  // namespace playhouse::app
