#include <fmt/format.h>

#include <cstdio>
#include <functional>

#include "playhouse/app/commands.h"
#include "playhouse/app/house.h"
#include "playhouse/app/open_house.h"
#include "playhouse/base/log.h"

namespace playhouse::app {

int run(const RunOptions& options) {
  House house(options.serving, options.running, QuitTime::kHonoured);
  return open_house(
      house, [&] { return house.read_world(options.world); }, options.running);
}

int serve(const ServeOptions& options) {
  House house(options.serving, options.running, QuitTime::kIgnored);
  return open_house(
      house, [&] { return house.read_cfg(options.file); }, options.running);
}

}  // namespace playhouse::app
