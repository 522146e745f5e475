/// Lidars on one thread: rays among 200,000 triangles that stand still and 1,000 boxes that move.

#include <benchmark/benchmark.h>

#include <cmath>

#include "playhouse/arena/sensing/ray_scene.h"
#include "playhouse/base/rng.h"
#include "playhouse/geom/trig.h"

namespace playhouse::arena {
namespace {

constexpr double kHalf = 50;  // m

Triangles box(const geom::Vec3& middle, const geom::Vec3& half) {
  const std::vector<geom::Vec2> outline{{middle.x - half.x, middle.y - half.y},
                                        {middle.x + half.x, middle.y - half.y},
                                        {middle.x + half.x, middle.y + half.y},
                                        {middle.x - half.x, middle.y + half.y}};
  const std::vector<geom::Outline> outlines{outline};
  Triangles triangles;
  add_extrusion(triangles, outlines, middle.z - half.z, middle.z + half.z);
  return triangles;
}

/// Hills, 300 squares each way.
Triangles hills() {
  constexpr std::uint32_t kSquares = 300;
  Triangles triangles;
  for (std::uint32_t i = 0; i <= kSquares; ++i)
    for (std::uint32_t j = 0; j <= kSquares; ++j) {
      const double x = 2 * kHalf * i / kSquares - kHalf, y = 2 * kHalf * j / kSquares - kHalf;
      triangles.p.push_back({x, y, 0.3 * geom::sincos(0.7 * x).sin * geom::sincos(0.5 * y).cos});
    }
  for (std::uint32_t i = 0; i < kSquares; ++i)
    for (std::uint32_t j = 0; j < kSquares; ++j) {
      const std::uint32_t a = i * (kSquares + 1) + j, b = a + kSquares + 1;
      triangles.corner.push_back({a, b, a + 1});
      triangles.corner.push_back({a + 1, b, b + 1});
    }
  return triangles;
}

void build(RayScene& scene) {
  Rng rng(1);
  const auto somewhere = [&rng] { return rng.uniform(-kHalf, kHalf); };
  std::vector<Triangles> fixed{hills()};
  for (int i = 0; i < 1667; ++i)
    fixed.push_back(
        box({somewhere(), somewhere(), 1.5}, {rng.uniform(0.05, 0.5), rng.uniform(0.05, 0.5), 1.5}));
  const std::vector<Owner> owners(fixed.size());
  scene.set_fixed(fixed, owners);
  const std::uint32_t shape = scene.add_shape(box({}, {0.2, 0.2, 0.2}));
  scene.set_instances(std::vector<RayScene::OwnedShape>(1000, {shape, {1, 1}}));
  for (std::uint32_t i = 0; i < 1000; ++i)
    scene.place(i, {somewhere(), somewhere(), rng.uniform(0, 3)}, geom::orientation(rng.uniform(-3, 3), {}));
  scene.commit();
}

/// Scanners of `rings` rings from -15 to 15 degrees (one: level) with `beams` beams each.
void cast_rings(benchmark::State& state, int rings, int beams) {
  RayScene scene;
  build(scene);
  std::vector<geom::Vec3> d;
  for (int ring = 0; ring < rings; ++ring)
    for (int k = 0; k < beams; ++k) {
      const geom::SinCos e =
          geom::sincos(rings > 1 ? (-15 + 30.0 * ring / (rings - 1)) * geom::kPi / 180 : 0);
      const geom::SinCos a = geom::sincos(2 * geom::kPi * k / beams);
      d.push_back({e.cos * a.cos, e.cos * a.sin, e.sin});
    }
  Rng rng(2);
  double sum = 0;
  std::size_t rays = 0;
  for (auto _ : state) {
    const double x = rng.uniform(-40, 40), y = rng.uniform(-40, 40);
    RayBatch batch;
    batch.p = {x, y, 1};
    for (std::size_t i = 0; i < d.size(); i += RayBatch::kMost) {
      batch.count = std::min(RayBatch::kMost, d.size() - i);
      for (std::size_t k = 0; k < batch.count; ++k) batch.set_ray(k, d[i + k], 100);
      scene.cast(batch);
      sum += batch.range[0];
    }
    rays += d.size();
  }
  benchmark::DoNotOptimize(sum);
  state.counters["rays/s"] = benchmark::Counter(static_cast<double>(rays), benchmark::Counter::kIsRate);
}

void lidar(benchmark::State& state) {
  cast_rings(state, 16, 1800);
}
void laser(benchmark::State& state) {
  cast_rings(state, 1, 360);
}
void commit(benchmark::State& state) {
  RayScene scene;
  build(scene);
  for (auto _ : state) {
    for (std::uint32_t i = 0; i < 1000; ++i) scene.place(i, {0.1 * i - 50, 0, 1}, {});
    scene.commit();
  }
}

BENCHMARK(lidar);
BENCHMARK(laser);
BENCHMARK(commit);

}  // namespace
}  // namespace playhouse::arena
