#include "playhouse/app/benches/bench_load.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "playhouse/app/commands/commands.h"
#include "playhouse/app/world_opener.h"
#include "playhouse/base/fail.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::app {
namespace {

constexpr std::uint32_t kRobots = 100000;  // default
constexpr int kRangers = 12;               // per robot

std::string world_text(std::uint32_t robots) {
  std::string text =
      "name \"load\"\ndefine eye ranger ( size [0 0 0] sensor ( range [0 2] fov 30 samples 1 ) )\n"
      "define robot position\n(\n  size [0.2 0.2 0.1]\n";
  const auto out = std::back_inserter(text);
  for (int k = 0; k < kRangers; ++k)
    fmt::format_to(out, "  eye( pose [0.05 0 -0.05 {}] )\n", 360 / kRangers * k);
  text += ")\n";
  const auto side = static_cast<std::uint32_t>(std::sqrt(robots)) + 1;
  for (std::uint32_t k = 0; k < robots; ++k)
    fmt::format_to(out, "robot( name \"r{}\" pose [{:.1f} {:.1f} 0 {}] )\n", k, 0.6 * (k % side),
                   0.6 * (k / side), 37 * k % 360);
  return text;
}

/// Peak memory of this process. [bytes]
std::uint64_t peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

double since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

int bench_load(const BenchOptions& options) {
  std::string text = world_text(options.robots > 0 ? options.robots : kRobots);
  config::MemoryFiles none({});
  const auto start = std::chrono::steady_clock::now();
  const Result<scene::SceneDesc> scene = scene::load_world_text(std::move(text), "load.world", none);
  if (!scene) return fail(scene.error());
  const double scene_time = since(start);
  Running running;
  running.seed = options.seed;
  running.workers = options.workers;
  const Result<std::unique_ptr<world::Engine>> engine =
      make_engine(*scene, running, controllers::Libraries::LibraryUse::kLoad, &warn);
  if (!engine) return fail(engine.error());
  const double wall_time = since(start);
  const world::World& world = (*engine)->world();
  fmt::print(
      R"({{"scenario":"load","robots":{},"models":{},"descriptions":{},"workers":{},"scene_time":{:.3f},"wall_time":{:.3f},"peak_bytes":{},"column_bytes":{},"hash":"{:016x}"}})"
      "\n",
      count_robots(world), world.models.size(), scene->models.size(), options.workers, scene_time, wall_time,
      peak_bytes(), world.bytes(), world.hash());
  return kDone;
}

}  // namespace playhouse::app
