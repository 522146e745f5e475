#include <fmt/format.h>

#include "playhouse/app/commands.h"
#include "playhouse/app/device_name.h"
#include "playhouse/app/fail.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse_client/client.h"

namespace playhouse::app {

int devices(const DevicesOptions& options) {
  const Result<client::Address> server = parse_server(options.server);
  if (!server) return fail(server.error(), kUsage);
  Result<client::Client> client = client::Client::connect(server->host, server->port);
  if (!client) return fail(client.error());
  const Result<std::vector<client::DeviceEntry>> devices = client->devices();
  if (!devices) return fail(devices.error());
  for (const client::DeviceEntry& device : *devices)
    fmt::print("{:<20} {}\n", device.name(), escaped(device.driver));  // a server may say anything
  return kDone;
}

}  // namespace playhouse::app
