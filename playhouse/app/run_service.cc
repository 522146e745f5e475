#include "playhouse/app/run_service.h"

#include <fmt/format.h>

#include "playhouse/app/device_service.h"
#include "playhouse/app/discovery/announce.h"
#include "playhouse/app/kept_files.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/log.h"
#include "playhouse/base/log_output.h"

namespace playhouse::app {
namespace {

Result<void> keep_what_was_read(const Service& service, const Running& running,
                                const std::vector<SaveAt>& saves) {
  std::vector<std::string> outputs{running.record, running.save_world};
  for (const SaveAt& save : saves) outputs.push_back(save.file);
  const std::vector<std::string> read = service.files_read();
  for (const std::string& output : outputs)
    if (const Result<void> kept = keep_files(output, read); !kept) return kept;
  return {};
}

}  // namespace

int run_service(Service& service, const std::function<Result<void>()>& read, const Running& running,
                const std::function<void(const std::vector<std::uint16_t>& ports)>& opened,
                const std::vector<SaveAt>& saves) {
  if (const Result<void> step = read(); !step) return fail_in_file(step.error(), service.other_errors());
  if (const config::CfgFile* const file = service.file_without_world())
    return serve_devices(*file, service.serving(), running, [&](const std::vector<std::uint16_t>& ports) {
      if (opened) opened(ports);
    });
  if (const Result<void> step = service.read_tls(); !step) return fail_in_file(step.error());
  if (const Result<void> step = service.open_ports(); !step) return fail(step.error());
  if (const Result<void> step = service.make_devices(); !step)
    return fail_in_file(step.error(), service.other_errors());
  if (const Result<void> step = service.open_following_ports(); !step) return fail(step.error());
  if (const Result<void> kept = keep_what_was_read(service, running, saves); !kept)
    return fail_in_file(kept.error());
  if (!running.save_world.empty())
    if (const Result<void> step = service.let_clients_save(running.save_world); !step)
      return fail_at(step.error());
  for (const SaveAt& save : saves)
    if (const Result<void> step = service.save_at(save); !step) return fail_at(step.error());
  if (const Result<void> step = service.read_guests(); !step) return fail_in_file(step.error());
  if (const Result<void> step = service.open_page(); !step) return fail(step.error());
  if (const Result<void> step = service.open_observers(); !step) return fail(step.error());
  if (!running.record.empty())
    if (const Result<void> step = service.record(running.record, running.record_only); !step)
      return fail_at(step.error());

  for (const std::string& place : service.places()) log::say(place);
  if (opened) opened(service.player_ports());
  const auto announced = announce(service.serving(), service.player_ports(), service.robot_names());
  const Outcome outcome = service.run();
  log::info("simulated {:.1f} s in {:.2f} s, {:.2f} times real time", outcome.sim_time, outcome.wall_time,
            outcome.real_time_factor);
  log::flush();  // so that the result is the last output on a terminal
  if (running.json) fmt::print("{}\n", outcome.json());
  if (outcome.signal != 0) return 128 + outcome.signal;
  return service.succeeded() ? kDone : kFailed;
}

}  // namespace playhouse::app
