/// How controllers behave over minutes in our worlds and in the 2D engine, and that it repeats.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "playhouse/base/testing_reference.h"
#include "playhouse/controllers/attach.h"
#include "playhouse/scenarios/scenario.h"
#include "playhouse/scenarios/testing_simulation.h"
#include "playhouse/world/state.h"

namespace playhouse::scenarios {
namespace {

using testing::load;
using testing::Simulation;

/// Mean distance of robots to the nearest other robot. [m]
double mean_nearest_neighbour(const world::World& world) {
  const world::Positions& robots = world.positions;
  double sum = 0;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    double nearest = 1e9;
    for (std::size_t k = 0; k < robots.size(); ++k) {
      if (k == i) continue;
      const geom::Pose& a = world.models.X_WM[robots.model[i].index];
      const geom::Pose& b = world.models.X_WM[robots.model[k].index];
      nearest = std::min(nearest, std::hypot(a.x - b.x, a.y - b.y));
    }
    sum += nearest;
  }
  return sum / static_cast<double>(robots.size());
}

TEST(Wander, never_touches_anything_in_the_cave_and_gets_about) {
  Simulation run(load("worlds/cave.world"));
  const std::size_t robots = run.world().positions.size();
  std::vector<double> far(robots, 0);
  std::vector<geom::Pose> start;
  for (const world::ModelRow model : run.world().positions.model)
    start.push_back(run.world().models.X_WM[model.index]);
  for (int tick = 0; tick < 3 * 600; ++tick) {
    run.step();
    for (std::size_t i = 0; i < robots; ++i) {
      const world::ModelRow model = run.world().positions.model[i];
      ASSERT_EQ(run.world().positions.stall[i], 0) << run.world().desc(model).name << ", tick " << tick;
      const geom::Pose& at = run.world().models.X_WM[model.index];
      far[i] = std::max(far[i], std::hypot(at.x - start[i].x, at.y - start[i].y));
    }
  }
  EXPECT_EQ(far.back(), 0) << "the guest has no controller";
  far.pop_back();
  EXPECT_GT(*std::min_element(far.begin(), far.end()), 1.0);
}

TEST(ExpandSwarm, gives_every_robot_more_room) {
  Simulation run(load("worlds/swarm.world"));
  const double before = mean_nearest_neighbour(run.world());
  run.step(600);
  EXPECT_GT(mean_nearest_neighbour(run.world()), 1.5 * before);
}

TEST(Source, of_the_cave_fills_up) {
  Simulation run(load("worlds/cave.world"));
  run.step(50);
  EXPECT_EQ(run.world().models.flags[run.world().find("source").index], 20);
}

/// Flags at the sink of a world after so many ticks.
std::int32_t delivered(Simulation& run, int ticks) {
  run.step(ticks);
  return run.world().models.flags[run.world().find("sink").index];
}

TEST(Fasr, brings_flags_all_the_time) {
  Simulation run(load("worlds/fasr.world"));
  const std::int32_t first = delivered(run, 1000), second = delivered(run, 800), third = delivered(run, 800);
  EXPECT_GE(first, 2);
  EXPECT_GE(second - first, 4);
  EXPECT_GE(third - second, 4);
}

TEST(Fasr, goes_on_from_a_saved_state_with_the_same_bits) {
  Simulation run(load("worlds/fasr.world")), again(load("worlds/fasr.world"), 2);
  run.step(900);
  std::vector<std::byte> state;
  ASSERT_TRUE(world::save_state(run.world(), state).ok());
  ASSERT_TRUE(world::load_state(again.world(), state).ok());
  run.step(300);
  again.step(300);
  EXPECT_EQ(run.world().hash(), again.world().hash());
}

TEST(Shy, runs_from_its_shared_library) {
  Simulation run(load("examples/controller/shy.world"));
  const geom::Pose start = run.world().models.X_WM[run.world().find("bold").index];
  run.step(100);
  const geom::Pose end = run.world().models.X_WM[run.world().find("bold").index];
  EXPECT_GT(std::hypot(end.x - start.x, end.y - start.y), 0.5);
}

TEST(ReferenceWorlds, get_their_controllers) {
  SKIP_WITHOUT_REFERENCE();
  const std::filesystem::path folder = reference() / "stage/worlds-data/worlds";
  std::size_t loaded = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".world") continue;
    const Result<scene::SceneDesc> scene = scene::load_world(entry.path().string());
    if (entry.path().filename() == "wifi.world") {  // written for Stage 2
      EXPECT_FALSE(scene);
      continue;
    }
    ASSERT_TRUE(scene) << scene.error().line();
    world::World world(*scene, 1);
    const auto attached = controllers::attach(world, {});
    EXPECT_TRUE(attached) << attached.error().line();
    ++loaded;
  }
  EXPECT_GE(loaded, 10u);
}

TEST(Determinism, holds_for_any_number_of_workers) {
  const auto hashes = [](Result<scene::SceneDesc> scene, unsigned workers) {
    Simulation run(std::move(scene), workers);
    run.step(100);
    return std::pair(run.world().hash(), run.world().sensed_hash());
  };
  for (const Scenario& scenario : kScenarios) {
    const auto one = hashes(make(scenario.name, 60), 1);
    EXPECT_EQ(one, hashes(make(scenario.name, 60), 1)) << scenario.name << " twice";
    EXPECT_EQ(one, hashes(make(scenario.name, 60), 2)) << scenario.name << " with 2 workers";
    EXPECT_EQ(one, hashes(make(scenario.name, 60), 4)) << scenario.name << " with 4 workers";
  }
  for (const char* file : {"worlds/cave.world", "examples/controller/shy.world"}) {
    EXPECT_EQ(hashes(load(file), 1), hashes(load(file), 4)) << file;
  }
}

}  // namespace
}  // namespace playhouse::scenarios
