/// Time to trace a large floor plan and to load a large world; a plan of corridors drawn here, so that it
/// runs anywhere.

#include <benchmark/benchmark.h>

#include "playhouse/scene/images/bitmap.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::scene {
namespace {

/// Walls two pixels thick every 40 pixels, with doors and some clutter: about the contours of a hospital.
Bitmap floor_plan(int width, int height) {
  Bitmap bitmap{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool wall = (x % 40 < 2 && y % 40 > 8) || (y % 40 < 2 && x % 40 > 8);
      bitmap.solid.push_back(wall || (x * 7 + y * 13) % 977 == 0 ? 1 : 0);
    }
  }
  return bitmap;
}

void trace(benchmark::State& state) {
  const Bitmap bitmap = floor_plan(3117, 1189);
  for (auto _ : state) benchmark::DoNotOptimize(trace_contours(bitmap));
}
BENCHMARK(trace)->Unit(benchmark::kMillisecond);

void load_robots(benchmark::State& state) {
  std::string text =
      "define sonar sensor ( range [0 5] fov 15 )\n"
      "define robot position ( size [0.44 0.38 0.22] ranger( sonar( ) sonar( ) sonar( ) sonar( ) ) )\n";
  for (int i = 0; i < state.range(0); ++i)
    text += "robot( name \"r" + std::to_string(i) + "\" pose [1 2 0 45] )\n";
  config::MemoryFiles files({});
  for (auto _ : state) benchmark::DoNotOptimize(load_world_text(text, "robots.world", files));
}
BENCHMARK(load_robots)->Arg(1000)->Arg(100000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace playhouse::scene
