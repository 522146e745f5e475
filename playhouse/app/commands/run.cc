#include <functional>

#include "playhouse/app/again.h"
#include "playhouse/app/commands/commands.h"
#include "playhouse/app/run_service.h"
#include "playhouse/app/service.h"

namespace playhouse::app {

int run(const RunOptions& options) {
  if (!options.again.empty()) return run_again(options);
  Service service(options.serving, options.running, QuitTime::kHonoured);
  return run_service(
      service,
      [&] {
        return options.from.empty() ? service.read_world(options.world) : service.read_saved(options.from);
      },
      options.running, {}, options.saves);
}

int serve(const ServeOptions& options) {
  Service service(options.serving, options.running, QuitTime::kIgnored);
  return run_service(
      service, [&] { return service.read_cfg(options.file); }, options.running);
}

}  // namespace playhouse::app
