#include "playhouse/app/open_house.h"

#include <fmt/format.h>

#include "playhouse/base/log.h"
#include "playhouse/base/log_output.h"

namespace playhouse::app {
namespace {

int fail(Exit code, const Result<void>& step) {
  log::error("{}", step.error().line());
  return code;
}

}  // namespace

int open_house(House& house, const std::function<Result<void>()>& read, const Running& running,
               const std::function<void()>& opened) {
  if (const Result<void> step = read(); !step) return fail(kUsage, step);
  if (const Result<void> step = house.open_ports(); !step) return fail(kFailed, step);
  if (const Result<void> step = house.furnish(); !step) return fail(kUsage, step);
  if (const Result<void> step = house.open_page(); !step) return fail(kFailed, step);

  for (const std::string& place : house.places()) log::say(place);
  if (opened) opened();
  const Outcome outcome = house.run();
  log::info("simulated {:.1f} s in {:.2f} s, {:.2f} times real time", outcome.sim_time, outcome.wall_time,
            outcome.real_time_factor);
  log::flush();  // the result is the last that a terminal shows
  if (running.json) fmt::print("{}\n", outcome.json());
  return outcome.signal != 0 ? 128 + outcome.signal : kDone;
}

}  // namespace playhouse::app
