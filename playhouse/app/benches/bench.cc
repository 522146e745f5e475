#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <span>
#include <vector>

#include "playhouse/app/benches/bench_figures.h"
#include "playhouse/app/benches/bench_load.h"
#include "playhouse/app/benches/bench_open.h"
#include "playhouse/app/benches/bench_server.h"
#include "playhouse/app/benches/bench_watched.h"
#include "playhouse/app/commands/commands.h"
#include "playhouse/app/world_opener.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/scenarios/scenario.h"
#include "playhouse/simd/instruction_set.h"

namespace playhouse::app {
namespace {

/// Resident memory of this process. [bytes]
std::uint64_t resident_bytes() {
  std::ifstream statm("/proc/self/statm");
  std::uint64_t pages = 0, resident = 0;
  statm >> pages >> resident;
  return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/// Scenarios at growing populations, at constant density.
struct Series {
  std::string_view name;
  std::array<std::string_view, 2> scenarios;  // the second is optional
};
constexpr Series kSeries[] = {{"vaughan2008", {"cave", "hospital"}}, {"diffusion", {"diffusion", ""}}};
constexpr std::uint32_t kPopulations[] = {1, 10, 100, 1000, 10000, 100000};

int unknown(const std::string& name) {
  std::vector<std::string_view> names;
  for (const scenarios::Scenario& scenario : scenarios::kScenarios) names.push_back(scenario.name);
  names.push_back("vaughan2008");
  names.push_back("world");
  names.push_back("load");
  names.push_back("open");
  names.push_back("server");
  names.push_back("watched");
  log::error("there is no scenario {}{}; there are {}", in_quotes(name), did_you_mean(name, names),
             fmt::join(names, ", "));
  return kUsage;
}

/// Cost of a run, without loading. [s]
struct Took {
  double wall_time = 0, cpu_time = 0;
};

void print_result(const BenchOptions& options, std::string_view scenario, world::Engine& engine,
                  const Took& took, std::uint64_t memory_before) {
  const world::World& world = engine.world();
  const std::uint64_t memory = resident_bytes();
  const std::size_t robots = count_robots(world);
  const double robot_ticks = static_cast<double>(std::max<std::size_t>(robots, 1)) *
                             static_cast<double>(std::max<std::uint64_t>(world.tick(), 1));
  fmt::print(
      R"({{"scenario":"{}","engine":"{}","robots":{},"workers":{},"instruction_set":"{}","ticks":{},"sim_time":{:.1f},"wall_time":{:.6f},"cpu_time":{:.6f},"ns_per_robot_tick":{:.1f},"real_time_factor":{:.2f},)"
      R"("rays":{},"rays_per_s":{:.0f},"memory_bytes":{},"world_bytes":{},"column_bytes":{},"hash":"{:016x}","sensed_hash":"{:016x}"}})"
      "\n",
      scenario, world.engine, robots, options.workers,
      simd::kInstructionSetNames[static_cast<std::size_t>(simd::instruction_set())], world.tick(),
      world.time(), took.wall_time, took.cpu_time, 1e9 * took.cpu_time / robot_ticks,
      world.time() / took.wall_time, engine.rays(), static_cast<double>(engine.rays()) / took.wall_time,
      memory, memory > memory_before ? memory - memory_before : 0, world.bytes(), world.hash(),
      world.sensed_hash());
  std::fflush(stdout);  // a series takes minutes
}

/// Runs the scene for `duration` simulated seconds.
int bench_scene(const BenchOptions& options, std::string_view scenario, const scene::SceneDesc& scene,
                double duration, std::uint64_t memory_before) {
  Result<std::unique_ptr<world::Engine>> engine =
      make_engine(scene, {.engine = options.engine, .seed = options.seed, .workers = options.workers},
                  controllers::Libraries::LibraryUse::kLoad, &warn);
  if (!engine) return fail_in_file(engine.error());
  // The same run as `playhouse run --fast --headless`.
  run::Simulation simulation(std::move(*engine), {.speed = 0, .duration = duration});
  const auto start = std::chrono::steady_clock::now();
  const double cpu_start = cpu_time(CLOCK_PROCESS_CPUTIME_ID);
  simulation.run();
  const Took took{
      .wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
      .cpu_time = cpu_time(CLOCK_PROCESS_CPUTIME_ID) - cpu_start};
  print_result(options, scenario, simulation.engine(), took, memory_before);
  return kDone;
}

int bench_scenario(const BenchOptions& options, const scenarios::Scenario& scenario, std::size_t robots) {
  const std::uint64_t memory_before = resident_bytes();
  const Result<scene::SceneDesc> scene = scenarios::make(scenario.name, robots);
  if (!scene) return fail(scene.error(), kUsage);
  return bench_scene(options, scenario.name, *scene,
                     options.duration > 0 ? options.duration : scenario.seconds, memory_before);
}

/// One line per scenario and population, or per scenario with --robots.
int bench_series(const BenchOptions& options, const Series& series) {
  const std::span<const std::uint32_t> populations =
      options.robots > 0 ? std::span(&options.robots, 1) : std::span(kPopulations);
  for (const std::string_view name : series.scenarios) {
    const scenarios::Scenario* scenario = scenarios::find(name);
    if (scenario == nullptr) continue;
    for (const std::uint32_t robots : populations) {
      malloc_trim(0);  // frees memory of the previous world
      if (const int failed = bench_scenario(options, *scenario, robots); failed != kDone) return failed;
    }
  }
  return kDone;
}

/// Runs for the file's duration, default a minute.
int bench_world(const BenchOptions& options) {
  constexpr double kMinute = 60;
  const std::uint64_t memory_before = resident_bytes();
  std::vector<Error> others;
  const Result<scene::SceneDesc> scene = read_scene(options.world, &others);
  if (!scene) return fail_in_file(scene.error(), others);
  const double of_file = scene->quit_time > 0 ? scene->quit_time : kMinute;
  return bench_scene(options, options.scenario, *scene, options.duration > 0 ? options.duration : of_file,
                     memory_before);
}

}  // namespace

int bench(const BenchOptions& options) {
  if (options.scenario == "world") return bench_world(options);
  if (options.scenario == "load") return bench_load(options);
  if (options.scenario == "open") return bench_open(options);
  if (options.scenario == "server") return bench_server(options);
  if (options.scenario == "watched") return bench_watched(options);
  const auto series = std::ranges::find(kSeries, options.scenario, &Series::name);
  if (series != std::end(kSeries)) return bench_series(options, *series);
  const scenarios::Scenario* scenario = scenarios::find(options.scenario);
  if (scenario == nullptr) return unknown(options.scenario);
  return bench_scenario(options, *scenario, options.robots > 0 ? options.robots : scenario->robots);
}

}  // namespace playhouse::app
