#pragma once

/// A world for tests, written as a world file, with an engine that only counts ticks and fills in what
/// a test puts into the columns. No threads: the test calls what the tick thread would.

#include <gtest/gtest.h>

#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/run/simulation.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/world/columns.h"

namespace playhouse::run::testing {

inline scene::SceneDesc scene_of(const std::string& text) {
  config::MemoryFiles none({});
  Result<scene::SceneDesc> scene = scene::load_world_text(text, "test.world", none);
  EXPECT_TRUE(scene) << (scene ? "" : scene.error().line());
  return scene ? std::move(*scene) : scene::SceneDesc{};
}

/// Every open sensor measures in every tick.
class StillEngine final : public world::Engine {
 public:
  explicit StillEngine(const scene::SceneDesc& scene, unsigned workers = 1)
      : world_(scene, 1), workers_(workers) {}
  void step() override {
    ++world_.tick_;
    world::each_kind_table([&]<typename Table>(Table world::Tables::*table) {
      if constexpr (requires(Table rows) { rows.measured_tick; })
        for (std::uint64_t& tick : (world_.*table).measured_tick) tick = world_.tick_;
    });
  }
  world::World& world() override { return world_; }
  world::Workers& workers() override { return workers_; }
  std::uint64_t rays() const override { return 0; }

 private:
  world::World world_;
  world::Workers workers_;
};

/// A wall clock for runs that wait for nothing.
inline double no_time_passes() {
  return 0;
}

/// Takes the run to the instant of a tick, earlier or later than now, and so many ticks on from there.
inline void rewind_to(Simulation& simulation, std::uint64_t instant, std::uint64_t ticks = 0) {
  simulation.requests().rewind(instant);
  simulation.extend(instant + ticks - simulation.world().tick());  // counts from now, so it wraps round
  simulation.run();
}

/// A world, its simulation, and single steps of it.
struct StillSimulation {
  explicit StillSimulation(const std::string& text, unsigned workers = 1)
      : scene(scene_of(text)),
        simulation(std::make_unique<StillEngine>(scene, workers),
                   {.speed = 0, .duration = 0, .clock = no_time_passes}) {}
  /// Does what was posted, then so many ticks.
  void run(int ticks) {
    simulation.extend(static_cast<std::uint64_t>(ticks));
    simulation.run();
  }
  world::World& world() { return simulation.engine().world(); }

  scene::SceneDesc scene;
  Simulation simulation;
};

}  // namespace playhouse::run::testing
