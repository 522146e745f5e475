/// Crowds of Pioneers on one thread: what a tick costs, and the hashes of where it ends.

#include <benchmark/benchmark.h>

#include <fmt/format.h>

#include "playhouse/base/assert.h"
#include "playhouse/stage/engine.h"
#include "playhouse/stage/testing_scenes.h"

namespace playhouse::stage {
namespace {

void run_crowd(benchmark::State& state, testing::Sensing sensing) {
  const scene::SceneDesc scene = testing::crowd(static_cast<std::size_t>(state.range(0)), sensing);
  auto made = make_engine(scene, {.seed = 1, .workers = static_cast<unsigned>(state.range(1))});
  PLAYHOUSE_ASSERT(made.ok());
  world::Engine& engine = **made;
  for (auto _ : state) engine.step();
  const auto ticks = static_cast<double>(state.iterations());
  state.counters["x_real_time"] = benchmark::Counter(ticks * scene.interval, benchmark::Counter::kIsRate);
  state.counters["rays/s"] =
      benchmark::Counter(static_cast<double>(engine.rays()), benchmark::Counter::kIsRate);
  state.counters["ns/robot"] = benchmark::Counter(ticks * static_cast<double>(state.range(0)) * 1e-9,
                                                  benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  double stalled = 0;
  for (const std::uint8_t stall : engine.world().positions.stall) stalled += stall;
  state.counters["stalled"] = stalled;
  state.SetLabel(fmt::format("{:016x} {:016x}", engine.world().hash(), engine.world().sensed_hash()));
}

void drive(benchmark::State& state) {
  run_crowd(state, testing::Sensing::kNone);
}
void sonar(benchmark::State& state) {
  run_crowd(state, testing::Sensing::kSonar);
}
void laser(benchmark::State& state) {
  run_crowd(state, testing::Sensing::kLaser);
}

// The hashes of the small crowds are those that motion_test.cc expects.
BENCHMARK(drive)->Args({1000, 1})->Iterations(600)->Unit(benchmark::kMicrosecond);
BENCHMARK(sonar)
    ->Args({100, 1})
    ->Args({1000, 1})
    ->Args({100000, 1})
    ->Iterations(20)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(laser)->Args({100, 1})->Args({1000, 1})->Args({1000, 2})->Iterations(20)->Unit(
    benchmark::kMicrosecond);

}  // namespace
}  // namespace playhouse::stage
