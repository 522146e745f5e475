#pragma once

/// Test fixtures: a world file in either engine, and arena scenes with driven robots.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/arena/engine.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/stage/engine.h"
#include "playhouse/world/population/population.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::arena {

/// A world file in one engine or the other.
struct EngineRun {
  std::unique_ptr<scene::SceneDesc> scene;
  std::unique_ptr<world::Engine> engine;

  EngineRun(const std::string& text, bool arena, unsigned workers = 1) {
    config::MemoryFiles files({{"w.world", text}});
    Result<scene::SceneDesc> loaded = scene::load_world_text(text, "w.world", files);
    EXPECT_TRUE(loaded) << loaded.error().line();
    scene = std::make_unique<scene::SceneDesc>(std::move(*loaded));
    engine = arena ? std::move(*make_engine(*scene, {.seed = 1, .workers = workers}))
                   : std::move(*stage::make_engine(*scene, {.seed = 1, .workers = workers}));
  }
  world::World& world() { return engine->world(); }
  void step(int ticks = 1) {
    for (int i = 0; i < ticks; ++i) engine->step();
  }
};

/// A scene in the arena.
class ArenaRun : public ::testing::Test {
 protected:
  void start(scene::SceneDesc scene, unsigned workers = 1) {
    scene_ = std::make_unique<scene::SceneDesc>(std::move(scene));
    engine_ = engine(workers);
  }
  std::unique_ptr<world::Engine> engine(unsigned workers) {
    auto made = make_engine(*scene_, {.seed = 1, .workers = workers});
    EXPECT_TRUE(made);
    return std::move(*made);
  }
  world::World& world() { return engine_->world(); }
  const geom::Pose& pose(const char* name) { return world().models.X_WM[world().find(name)]; }
  void drive(const char* name, geom::Twist velocity) {
    const world::ModelRow model = world().find(name);
    world::subscribe(world(), model);
    ASSERT_TRUE(world::command_velocity(world(), world().position(world().id(model)), velocity));
  }
  void run(double seconds) {
    for (int i = 0; i < std::lround(seconds / scene_->interval); ++i) engine_->step();
  }
  /// Expects equal hashes with 1 and 3 workers, and with 2 workers when resumed from a saved state
  /// at every `every`-th tick. `command` runs before each tick, `look` on each loaded state.
  void expect_the_same_run(int ticks, int every, const std::function<void(world::World&, int tick)>& command,
                           const std::function<void(world::World&)>& look) {
    std::vector<std::uint64_t> hashes;
    std::vector<std::vector<std::byte>> saved(ticks);
    for (const unsigned workers : {1u, 3u}) {
      engine_ = engine(workers);
      std::vector<std::uint64_t> now;
      for (int tick = 0; tick < ticks; ++tick) {
        command(world(), tick);
        saved[tick].clear();
        ASSERT_TRUE(world::save_state(world(), saved[tick]));
        engine_->step();
        now.push_back(world().hash());
      }
      if (hashes.empty()) hashes = now;
      EXPECT_EQ(now, hashes);
    }
    for (int from = 1; from < ticks; from += every) {
      engine_ = engine(2);
      ASSERT_TRUE(world::load_state(world(), saved[from]));
      look(world());
      for (int tick = from; tick < ticks; ++tick) {
        if (tick > from) command(world(), tick);
        engine_->step();
        ASSERT_EQ(world().hash(), hashes[tick]) << "from " << from << " at " << tick;
      }
    }
  }
  std::unique_ptr<scene::SceneDesc> scene_;
  std::unique_ptr<world::Engine> engine_;
};

}  // namespace playhouse::arena
