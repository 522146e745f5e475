// What it costs that models come and go, in worlds of many robots with 16 sonars and a laser of 180 beams.

#include <benchmark/benchmark.h>

#include <vector>

#include "playhouse/base/assert.h"
#include "playhouse/world/population/population.h"

namespace playhouse::world {
namespace {

scene::ModelDesc model(const std::string& name, scene::ModelKind kind, std::int32_t parent) {
  scene::ModelDesc desc;
  desc.name = desc.alias = name;
  desc.kind = kind;
  desc.parent = parent;
  return desc;
}

/// Row 0: a robot; 1: its sonars; 2: its laser.
scene::SceneDesc one_robot() {
  scene::SceneDesc scene;
  scene.models.push_back(model("r", scene::ModelKind::kPosition, -1));
  scene.models.back().position.emplace();
  scene.models.push_back(model("r.ranger:0", scene::ModelKind::kRanger, 0));
  scene.models.back().sensors.resize(16);
  scene.models.push_back(model("r.ranger:1", scene::ModelKind::kRanger, 0));
  scene.models.back().sensors.resize(1);
  scene.models.back().sensors[0].samples = 180;
  return scene;
}

class Crowd {
 public:
  explicit Crowd(std::size_t robots) {
    while (robots_.size() < robots) come();
  }
  void come() {
    const Result<ModelId> id = spawn(world_, 0, {});
    PLAYHOUSE_ASSERT(id.ok());
    robots_.push_back(*id);
  }
  /// `count` of them, spread over the population.
  std::vector<ModelId> choose(std::size_t count) {
    std::vector<ModelId> chosen;
    const std::size_t step = robots_.size() / count;
    for (std::size_t i = count; i-- > 0;) {
      chosen.push_back(robots_[i * step + step / 2]);
      robots_.erase(robots_.begin() + static_cast<std::ptrdiff_t>(i * step + step / 2));
    }
    return chosen;
  }
  World& world() { return world_; }

 private:
  const scene::SceneDesc scene_ = one_robot();
  World world_{scene_, 1};
  std::vector<ModelId> robots_;
};

void spawns(benchmark::State& state) {
  Crowd crowd(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) {
    crowd.come();
    state.PauseTiming();
    PLAYHOUSE_ASSERT(despawn(crowd.world(), crowd.choose(1)[0]).ok());
    state.ResumeTiming();
  }
}
BENCHMARK(spawns)->Arg(1000);

void despawns(benchmark::State& state) {
  Crowd crowd(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) {
    PLAYHOUSE_ASSERT(despawn(crowd.world(), crowd.choose(1)[0]).ok());
    state.PauseTiming();
    crowd.come();
    state.ResumeTiming();
  }
}
BENCHMARK(despawns)->Arg(1000);

/// A tenth of them at once.
void despawns_of_many(benchmark::State& state) {
  Crowd crowd(static_cast<std::size_t>(state.range(0)));
  const auto count = static_cast<std::size_t>(state.range(0)) / 10;
  for (auto _ : state) {
    PLAYHOUSE_ASSERT(despawn(crowd.world(), crowd.choose(count)).ok());
    state.PauseTiming();
    for (std::size_t i = 0; i < count; ++i) crowd.come();
    state.ResumeTiming();
  }
}
BENCHMARK(despawns_of_many)->Arg(1000);

}  // namespace
}  // namespace playhouse::world
