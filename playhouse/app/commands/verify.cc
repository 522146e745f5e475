#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "playhouse/app/commands/commands.h"
#include "playhouse/app/world_opener.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::app {
namespace {

/// One of the compared runs.
struct Side {
  unsigned workers;
  std::unique_ptr<world::Engine> engine;
};

/// A single worker count is run twice: runs may differ for other reasons than threads.
std::vector<unsigned> workers_of(const VerifyOptions& options) {
  std::vector<unsigned> workers = options.workers;
  if (workers.empty()) workers = {1, 2, 4};
  if (workers.size() == 1) workers.push_back(workers.front());
  return workers;
}

Result<std::vector<Side>> open_sides(const scene::SceneDesc& scene, const VerifyOptions& options,
                                     std::vector<Error>& others) {
  std::vector<Side> sides;
  for (const unsigned workers : workers_of(options)) {
    Running running = options.running;
    running.workers = workers;
    // Warnings are about the world: print them once.
    const Warn warn_once = sides.empty() ? Warn(&warn) : Warn([](const std::string&) {});
    Result<std::unique_ptr<world::Engine>> engine =
        make_engine(scene, running, controllers::Libraries::LibraryUse::kLoad, warn_once, {}, &others);
    if (!engine) return engine.error();
    sides.push_back({workers, std::move(*engine)});
  }
  return sides;
}

std::string text_of(const world::Difference& difference, const world::World& world) {
  const world::ModelRow model = world.row(difference.model);
  if (!model) return difference.text();
  return fmt::format("model {} (id {}), column {}", in_quotes(world.name(model)), difference.model.value,
                     difference.column);
}

/// Reports the first difference of any run from the first one; false if there is none.
bool tell_difference(const std::vector<Side>& sides) {
  world::World& first = sides.front().engine->world();
  for (std::size_t i = 1; i < sides.size(); ++i) {
    world::World& other = sides[i].engine->world();
    if (other.hash() == first.hash()) continue;
    const auto difference = world::first_difference(first, other);
    fmt::print("tick {}: run 1 ({} workers) and run {} ({} workers) differ: {}\n", first.tick(),
               sides.front().workers, i + 1, sides[i].workers,
               difference ? text_of(*difference, first) : "hash");
    return true;
  }
  return false;
}

}  // namespace

int verify(const VerifyOptions& options) {
  std::vector<Error> others;
  const Result<scene::SceneDesc> scene = read_scene(options.world, &others);
  if (!scene) return fail_in_file(scene.error(), others);
  others.clear();
  const Result<std::vector<Side>> sides = open_sides(*scene, options, others);
  if (!sides) return fail_in_file(sides.error(), others);
  for (std::uint64_t tick = 0;; ++tick) {
    if (tell_difference(*sides)) return kFailed;
    if (tick == options.ticks) break;
    for (const Side& side : *sides) side.engine->step();
  }
  std::vector<unsigned> workers;
  for (const Side& side : *sides) workers.push_back(side.workers);
  fmt::print("{} ticks are the same with {} workers, hash {:016x}\n", options.ticks, fmt::join(workers, ", "),
             sides->front().engine->world().hash());
  return kDone;
}

}  // namespace playhouse::app
