// What an instant of a run's history costs, and how large it is: 1,000 robots with lasers of 180 beams.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "playhouse/scene/world_loader.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::run {
namespace {

scene::SceneDesc scene_of_robots(int robots) {
  std::string text = "define scanner ranger( sensor( samples 180 fov 180 ) )\n";
  for (int k = 0; k < robots; ++k)
    text += fmt::format("position( name \"r{}\" pose [{} {} 0 0] scanner() )\n", k, k % 100, k / 100);
  config::MemoryFiles none({});
  return *scene::load_world_text(text, "bench.world", none);
}

void save(benchmark::State& state) {
  const scene::SceneDesc scene = scene_of_robots(static_cast<int>(state.range(0)));
  const world::World world(scene, 1);
  std::vector<std::byte> bytes;
  for (auto _ : state) {
    bytes.clear();
    benchmark::DoNotOptimize(world::save_state(world, bytes).ok());
  }
  state.counters["bytes"] = static_cast<double>(bytes.size());
}
BENCHMARK(save)->Arg(100)->Arg(1000)->Unit(benchmark::kMicrosecond);

void load(benchmark::State& state) {
  const scene::SceneDesc scene = scene_of_robots(static_cast<int>(state.range(0)));
  world::World world(scene, 1);
  std::vector<std::byte> bytes;
  benchmark::DoNotOptimize(world::save_state(world, bytes).ok());
  for (auto _ : state) benchmark::DoNotOptimize(world::load_state(world, bytes).ok());
}
BENCHMARK(load)->Arg(100)->Arg(1000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace playhouse::run
