#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <vector>

#include "playhouse/app/bench_load.h"
#include "playhouse/app/bench_open.h"
#include "playhouse/app/bench_server.h"
#include "playhouse/app/commands.h"
#include "playhouse/app/fail.h"
#include "playhouse/app/world_opener.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/scenarios/scenario.h"
#include "playhouse/stage/instruction_set.h"

namespace playhouse::app {
namespace {

/// Memory of this process that is in use now. [bytes]
std::uint64_t resident_bytes() {
  std::ifstream statm("/proc/self/statm");
  std::uint64_t pages = 0, resident = 0;
  statm >> pages >> resident;
  return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

int unknown(const std::string& name) {
  std::vector<std::string_view> names;
  for (const scenarios::Scenario& scenario : scenarios::kScenarios) names.push_back(scenario.name);
  names.push_back("world");
  names.push_back("load");
  names.push_back("open");
  names.push_back("server");
  log::error("there is no scenario {}{}; there are {}", in_quotes(name), did_you_mean(name, names),
             fmt::join(names, ", "));
  return kUsage;
}

void print_result(const BenchOptions& options, world::Engine& engine, double wall_time,
                  std::uint64_t memory_before) {
  const world::World& world = engine.world();
  const std::uint64_t memory = resident_bytes();
  fmt::print(
      R"({{"scenario":"{}","robots":{},"workers":{},"instruction_set":"{}","ticks":{},"sim_time":{:.1f},"wall_time":{:.6f},"real_time_factor":{:.2f},)"
      R"("rays":{},"rays_per_s":{:.0f},"memory_bytes":{},"world_bytes":{},"column_bytes":{},"hash":"{:016x}","sensed_hash":"{:016x}"}})"
      "\n",
      options.scenario, count_robots(world), options.workers,
      stage::kInstructionSetNames[static_cast<std::size_t>(stage::instruction_set())], world.tick(),
      world.time(), wall_time, world.time() / wall_time, engine.rays(),
      static_cast<double>(engine.rays()) / wall_time, memory,
      memory > memory_before ? memory - memory_before : 0, world.bytes(), world.hash(), world.sensed_hash());
}

/// The scene runs for `duration` simulated seconds.
int bench_scene(const BenchOptions& options, const scene::SceneDesc& scene, double duration,
                std::uint64_t memory_before) {
  Result<std::unique_ptr<world::Engine>> engine = make_engine(
      scene, {.seed = options.seed, .workers = options.workers}, controllers::Libraries::Use::kLoad, &warn);
  if (!engine) return fail(engine.error());
  // The run itself is the one that `playhouse run --fast --headless` does.
  drivers::Simulation simulation(std::move(*engine), {.speed = 0, .duration = duration});
  const auto start = std::chrono::steady_clock::now();
  simulation.run();
  const double wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  print_result(options, simulation.engine(), wall_time, memory_before);
  return kDone;
}

int bench_scenario(const BenchOptions& options, const scenarios::Scenario& scenario) {
  const std::uint64_t memory_before = resident_bytes();
  const Result<scene::SceneDesc> scene =
      scenarios::make(scenario.name, options.robots > 0 ? options.robots : scenario.robots);
  if (!scene) return fail(scene.error(), kUsage);
  return bench_scene(options, *scene, options.duration > 0 ? options.duration : scenario.seconds,
                     memory_before);
}

/// As long as the file says, or a minute.
int bench_world(const BenchOptions& options) {
  constexpr double kMinute = 60;
  const std::uint64_t memory_before = resident_bytes();
  std::vector<Error> others;
  const Result<scene::SceneDesc> scene = read_scene(options.world, &others);
  if (!scene) return fail_in_file(scene.error(), others);
  const double of_file = scene->quit_time > 0 ? scene->quit_time : kMinute;
  return bench_scene(options, *scene, options.duration > 0 ? options.duration : of_file, memory_before);
}

}  // namespace

int bench(const BenchOptions& options) {
  if (options.scenario == "world") return bench_world(options);
  if (options.scenario == "load") return bench_load(options);
  if (options.scenario == "open") return bench_open(options);
  if (options.scenario == "server") return bench_server(options);
  const scenarios::Scenario* scenario = scenarios::find(options.scenario);
  return scenario == nullptr ? unknown(options.scenario) : bench_scenario(options, *scenario);
}

}  // namespace playhouse::app
