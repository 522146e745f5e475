#include <memory>

#include "playhouse/app/commands/commands.h"
#include "playhouse/app/run_service.h"
#include "playhouse/app/service.h"
#include "playhouse/base/log.h"
#include "playhouse/bridge/gym/link.h"

namespace playhouse::app {

int gym(const GymOptions& options) {
  Service service(options.serving, options.running, QuitTime::kIgnored);
  std::unique_ptr<drivers::gym::Link> link;  // destroyed before the service
  Result<void> linked;
  const int code = run_service(
      service, [&] { return service.read_world(options.world); }, options.running,
      [&](const std::vector<std::uint16_t>&) {
        link = std::make_unique<drivers::gym::Link>(service.simulation(), options.socket);
        linked = link->start();
        if (linked) return;
        log::error("{}", linked.error().line());
        service.stop();
      });
  return linked ? code : kFailed;
}

}  // namespace playhouse::app
