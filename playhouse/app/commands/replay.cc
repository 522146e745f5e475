#include <vector>

#include "playhouse/app/again.h"
#include "playhouse/app/commands/commands.h"
#include "playhouse/app/service.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/log.h"
#include "playhouse/base/log_output.h"

namespace playhouse::app {

int replay(const ReplayOptions& options) {
  std::vector<Error> others;
  Result<std::unique_ptr<OpenedRecording>> opened = open_recording(options.file, options.running, &others);
  if (!opened) return fail_in_file(opened.error(), others);
  Service service(options.serving, options.running, QuitTime::kIgnored);
  service.play(**opened);
  if (const Result<void> step = service.make_devices(); !step) return fail(step.error());
  if (const Result<void> step = service.read_guests(); !step) return fail_in_file(step.error());
  if (const Result<void> step = service.open_page(); !step) return fail(step.error());
  if (const Result<void> step = service.open_observers(); !step) return fail(step.error());
  for (const std::string& place : service.places()) log::say(place);
  const Outcome outcome = service.run();
  return outcome.signal != 0 ? 128 + outcome.signal : kDone;
}

}  // namespace playhouse::app
