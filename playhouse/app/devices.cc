#include <fmt/format.h>

#include "playhouse/app/commands.h"
#include "playhouse/base/log.h"
#include "playhouse_client/client.h"

namespace playhouse::app {

int devices(const DevicesOptions& options) {
  Result<client::Client> client = client::Client::connect(options.server);
  if (!client) {
    log::error("{}", client.error().line());
    return kFailed;
  }
  const Result<std::vector<client::DeviceEntry>> devices = client->devices();
  if (!devices) {
    log::error("{}", devices.error().line());
    return kFailed;
  }
  for (const client::DeviceEntry& device : *devices) fmt::print("{:<20} {}\n", device.name(), device.driver);
  return kDone;
}

}  // namespace playhouse::app
