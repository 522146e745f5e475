#include "playhouse/app/again.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>

#include "playhouse/app/service.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/base/log_output.h"
#include "playhouse/base/version.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::app {

Result<std::unique_ptr<OpenedRecording>> open_recording(const std::string& file, const Running& running,
                                                        std::vector<Error>* others) {
  const Result<std::unique_ptr<record::ByteSource>> source = record::open_source(file);
  if (!source) return source.error();
  Result<record::Recording> recording = record::read_recording(**source);
  if (!recording) return Error{escaped(file), recording.error().text};
  auto opened = std::make_unique<OpenedRecording>();
  opened->recording = std::move(*recording);
  Result<scene::SceneDesc> scene = scene_of(opened->recording.start.sources, file, others);
  if (!scene) return Error{escaped(file), scene.error().text};
  opened->scene = std::move(*scene);
  Running same = running;
  same.engine = opened->recording.start.engine;
  same.seed = opened->recording.start.seed;
  Result<std::unique_ptr<world::Engine>> engine =
      make_engine(opened->scene, same, controllers::Libraries::LibraryUse::kLoad, &warn, {}, others);
  if (!engine) return engine.error();
  opened->rerun = std::make_unique<record::Rerun>(opened->recording, std::move(*engine));
  if (const Result<void> begun = opened->rerun->begin(); !begun)
    return Error{escaped(file), begun.error().text};
  if (opened->recording.cut)
    warn(escaped(file) + ": was not finished; what follows its last whole chunk is lost");
  return opened;
}

namespace {

/// What a difference may come from.
std::string other_build(const std::string& recorded) {
  if (recorded == build()) return "";
  return fmt::format("; Playhouse {} recorded it, this is {}", escaped(recorded), build());
}

}  // namespace

int run_again(const RunOptions& options) {
  std::vector<Error> others;
  const Result<std::unique_ptr<OpenedRecording>> opened =
      open_recording(options.again, options.running, &others);
  if (!opened) return fail_in_file(opened.error(), others);
  record::Rerun& rerun = *(*opened)->rerun;
  const auto start = std::chrono::steady_clock::now();
  while (!rerun.at_end() && !rerun.differs()) rerun.step();
  const double wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (rerun.differs())
    return fail_at({escaped(options.again), "the run differs from its recording " + *rerun.differs() +
                                                other_build((*opened)->recording.start.build)});
  const Outcome outcome = outcome_of(rerun, wall_time);
  log::info("the same run to the bit: {:.1f} s simulated in {:.2f} s, {} hashes compared", outcome.sim_time,
            wall_time, rerun.checks());
  log::flush();
  if (options.running.json) fmt::print("{}\n", outcome.json());
  return kDone;
}

}  // namespace playhouse::app
