#pragma once

/// Shared fixtures for tests of whole simulations.

#include <gtest/gtest.h>

#include <filesystem>

#include "playhouse/controllers/attach.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/stage/engine.h"

namespace playhouse::scenarios::testing {

/// A scene in the 2D engine, with its controllers.
class ScenarioRun {
 public:
  explicit ScenarioRun(Result<scene::SceneDesc> loaded, unsigned workers = 1) : scene_(std::move(loaded)) {
    EXPECT_TRUE(scene_) << scene_.error().line();
    controllers::describe_for(*scene_);
    auto engine = stage::make_engine(*scene_, {.seed = 1, .workers = workers});
    EXPECT_TRUE(engine) << engine.error().line();
    engine_ = std::move(*engine);
    const std::vector<std::filesystem::path> folders{EXAMPLE_CONTROLLERS};
    const auto attached = controllers::attach(engine_->world(), {.folders = folders});
    EXPECT_TRUE(attached) << attached.error().line();
  }
  world::World& world() { return engine_->world(); }
  void step(int ticks = 1) {
    for (int k = 0; k < ticks; ++k) engine_->step();
  }

 private:
  Result<scene::SceneDesc> scene_;
  std::unique_ptr<world::Engine> engine_;
};

/// A world file of this tree.
inline Result<scene::SceneDesc> load(const std::string& file) {
  return scene::load_world(std::string(PLAYHOUSE_SOURCE_DIR) + "/" + file);
}

}  // namespace playhouse::scenarios::testing
