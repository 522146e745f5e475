/// Cost of one decision per robot, on made-up beams in the columns of a thousand robots.

#include <benchmark/benchmark.h>

#include "playhouse/controllers/attach.h"
#include "playhouse/controllers/testing/scenes.h"

namespace playhouse::controllers {
namespace {

constexpr std::size_t kRobots = 1000;

void decide(benchmark::State& state, const std::vector<scene::RangerSensorDesc>& sensors, const char* ctrl) {
  const scene::SceneDesc scene = testing::robots(kRobots, sensors, ctrl);
  world::World world(scene, 1);
  if (!attach(world, {})) return state.SkipWithError("no controllers");
  std::vector<float> beams(997);
  Rng random(1);
  for (float& beam : beams) beam = static_cast<float>(random.uniform(0.4, 5));
  testing::measure(world, beams);
  for (auto _ : state) {
    for (std::uint64_t& tick : world.rangers.measured_tick) ++tick;
    ++world.tick_;
    testing::decide(world);
    benchmark::DoNotOptimize(world.positions.command.data());
  }
  state.SetItemsProcessed(state.iterations() * kRobots);
}

BENCHMARK_CAPTURE(decide, wander_180_beams, testing::scanner(180), "wander");
BENCHMARK_CAPTURE(decide, expand_swarm_16_sonars, testing::ring(16), "expand_swarm");
BENCHMARK_CAPTURE(decide, expand_pioneer_16_sonars, testing::ring(16), "expand_pioneer");

}  // namespace
}  // namespace playhouse::controllers
