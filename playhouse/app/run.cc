#include <fmt/format.h>

#include <cstdio>
#include <functional>

#include "playhouse/app/again.h"
#include "playhouse/app/commands.h"
#include "playhouse/app/run_service.h"
#include "playhouse/app/service.h"
#include "playhouse/base/log.h"

namespace playhouse::app {
namespace {

int code_of(const Service& service, int code) {
  return code == kDone && !service.all_saved() ? kFailed : code;
}

}  // namespace

int run(const RunOptions& options) {
  if (!options.again.empty()) return run_again(options);
  Service service(options.serving, options.running, QuitTime::kHonoured);
  const int code = run_service(
      service,
      [&] {
        return options.from.empty() ? service.read_world(options.world) : service.read_saved(options.from);
      },
      options.running, {}, options.saves);
  return code_of(service, code);
}

int serve(const ServeOptions& options) {
  Service service(options.serving, options.running, QuitTime::kIgnored);
  const int code = run_service(
      service, [&] { return service.read_cfg(options.file); }, options.running);
  return code_of(service, code);
}

}  // namespace playhouse::app
