/// How controllers behave over minutes in our worlds and in the 2D engine, and that it repeats.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

#include "playhouse/base/testing/reference.h"
#include "playhouse/controllers/attach.h"
#include "playhouse/scenarios/scenario.h"
#include "playhouse/scenarios/testing_simulation.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::scenarios {
namespace {

using testing::load;
using testing::ScenarioRun;

/// Mean distance of robots to the nearest other robot. [m]
double mean_nearest_neighbour(const world::World& world) {
  const world::Positions& robots = world.positions;
  double sum = 0;
  for (const world::PositionRow i : robots.model.rows()) {
    double nearest = 1e9;
    for (const world::PositionRow k : robots.model.rows()) {
      if (k == i) continue;
      const geom::Pose& a = world.models.X_WM[robots.model[i]];
      const geom::Pose& b = world.models.X_WM[robots.model[k]];
      nearest = std::min(nearest, std::hypot(a.x - b.x, a.y - b.y));
    }
    sum += nearest;
  }
  return sum / static_cast<double>(robots.size());
}

TEST(Wander, never_touches_anything_in_the_cave_and_gets_about) {
  ScenarioRun run(load("worlds/cave.world"));
  const std::size_t robots = run.world().positions.size();
  ByRow<world::PositionTable, double> far(robots, 0);
  ByRow<world::PositionTable, geom::Pose> start;
  for (const world::ModelRow model : run.world().positions.model)
    start.push_back(run.world().models.X_WM[model]);
  for (int tick = 0; tick < 3 * 600; ++tick) {
    run.step();
    for (const world::PositionRow robot : run.world().positions.model.rows()) {
      const world::ModelRow model = run.world().positions.model[robot];
      ASSERT_EQ(run.world().positions.stall[robot], 0) << run.world().desc(model).name << ", tick " << tick;
      const geom::Pose& at = run.world().models.X_WM[model];
      far[robot] = std::max(far[robot], std::hypot(at.x - start[robot].x, at.y - start[robot].y));
    }
  }
  EXPECT_EQ(far.back(), 0) << "the guest has no controller";
  far.pop_back();
  EXPECT_GT(*std::min_element(far.begin(), far.end()), 1.0);
}

TEST(ExpandSwarm, gives_every_robot_more_room) {
  ScenarioRun run(load("worlds/swarm.world"));
  const double before = mean_nearest_neighbour(run.world());
  run.step(600);
  EXPECT_GT(mean_nearest_neighbour(run.world()), 1.5 * before);
}

/// How alike robots are turned: 1 where all are turned the same way, about 0 where every way is.
double alignment(const world::World& world) {
  double x = 0, y = 0;
  for (const world::ModelRow robot : world.positions.model) {
    x += std::cos(world.models.X_WM[robot].a);
    y += std::sin(world.models.X_WM[robot].a);
  }
  return std::hypot(x, y) / static_cast<double>(world.positions.size());
}

TEST(PioneerFlocking, turns_robots_that_see_each_other_the_same_way) {
  std::string text = R"(
define sonar sensor( range [0 5] fov 10 samples 1 )
define robot position(
  size [0.44 0.38 0.22] localization "gps" fiducial_return 1 ctrl "pioneer_flocking"
  ranger( sonar( pose [0 0 0 90] ) sonar( pose [0 0 0 50] ) sonar( pose [0 0 0 30] ) sonar( pose [0 0 0 10] )
          sonar( pose [0 0 0 -10] ) sonar( pose [0 0 0 -30] ) sonar( pose [0 0 0 -50] )
          sonar( pose [0 0 0 -90] ) )
  fiducial() )
)";
  for (int k = 0; k < 16; ++k)
    text += fmt::format("robot( pose [{} {} 0 {}] )\n", 2.5 * (k % 4), 2.5 * (k / 4), (37 * k) % 360);
  config::MemoryFiles files({});
  ScenarioRun run(scene::load_world_text(text, "flock.world", files));
  const double before = alignment(run.world());
  run.step(600);
  EXPECT_LT(before, 0.5);
  EXPECT_GT(alignment(run.world()), 0.9);
}

TEST(LaserNoise, shows_in_what_others_see_and_repeats_with_any_number_of_workers) {
  const std::string text = R"(
model( pose [3 0 0 0] size [0.1 10 1] )
position( size [0.4 0.4 0.2] ctrl "wander"
  ranger( ctrl "lasernoise" sensor( range [0 8] fov 20 samples 200 ) ) )
)";
  config::MemoryFiles files({});
  ScenarioRun run(scene::load_world_text(text, "noise.world", files));
  ScenarioRun again(scene::load_world_text(text, "noise.world", files), 3);
  run.step(2);
  again.step(2);
  const auto& ranges = run.world().sensors.ranges;
  const auto [least, most] = std::ranges::minmax_element(ranges);
  EXPECT_LT(*least, 2.95 * 0.95);
  EXPECT_GT(*most, 2.95 * 1.05);
  EXPECT_EQ(run.world().hash(), again.world().hash());
  EXPECT_EQ(run.world().sensed_hash(), again.world().sensed_hash());
}

TEST(Dynamic, has_parts_that_go_on_from_a_saved_state) {
  const std::string text = R"(position( size [0.4 0.4 0.2] ctrl "dynamic" velocity [0.1 0 0 10] ))";
  config::MemoryFiles files({});
  ScenarioRun run(scene::load_world_text(text, "d.world", files));
  ScenarioRun again(scene::load_world_text(text, "d.world", files));
  run.step(5);
  EXPECT_EQ(run.world().models.size(), 101u);
  std::vector<std::byte> state;
  ASSERT_TRUE(world::save_state(run.world(), state).ok());
  ASSERT_TRUE(world::load_state(again.world(), state).ok());
  run.step(20);
  again.step(20);
  EXPECT_EQ(again.world().models.size(), 101u);
  EXPECT_EQ(run.world().hash(), again.world().hash());
}

TEST(Source, of_the_cave_fills_up) {
  ScenarioRun run(load("worlds/cave.world"));
  run.step(50);
  EXPECT_EQ(run.world().models.flags[run.world().find("source")], 20);
}

/// Flags at the sink of a world after so many ticks.
std::int32_t delivered(ScenarioRun& run, int ticks) {
  run.step(ticks);
  return run.world().models.flags[run.world().find("sink")];
}

TEST(Fasr, brings_flags_all_the_time) {
  ScenarioRun run(load("worlds/fasr.world"));
  const std::int32_t first = delivered(run, 1000), second = delivered(run, 800), third = delivered(run, 800);
  EXPECT_GE(first, 2);
  EXPECT_GE(second - first, 4);
  EXPECT_GE(third - second, 4);
}

TEST(Fasr, goes_on_from_a_saved_state_with_the_same_bits) {
  ScenarioRun run(load("worlds/fasr.world")), again(load("worlds/fasr.world"), 2);
  run.step(900);
  std::vector<std::byte> state;
  ASSERT_TRUE(world::save_state(run.world(), state).ok());
  ASSERT_TRUE(world::load_state(again.world(), state).ok());
  run.step(300);
  again.step(300);
  EXPECT_EQ(run.world().hash(), again.world().hash());
}

TEST(Shy, runs_from_its_shared_library) {
  ScenarioRun run(load("examples/controller/shy.world"));
  const geom::Pose start = run.world().models.X_WM[run.world().find("bold")];
  run.step(100);
  const geom::Pose end = run.world().models.X_WM[run.world().find("bold")];
  EXPECT_GT(std::hypot(end.x - start.x, end.y - start.y), 0.5);
}

TEST(StagesWorlds, get_their_controllers) {
  SKIP_WITHOUT_STAGE();
  for (const std::string name :
       {"SFU", "camera", "circuit", "everything", "fasr", "fasr2", "fasr_plan", "large", "pioneer_follow",
        "pioneer_walle", "sensor_noise_demo", "sensor_noise_module_demo", "simple", "wifi"}) {
    const Result<scene::SceneDesc> scene =
        scene::load_world((stage_source() / "worlds" / (name + ".world")).string());
    ASSERT_TRUE(scene) << scene.error().line();
    world::World world(*scene, 1);
    const auto attached = controllers::attach(world, {});
    EXPECT_TRUE(attached) << attached.error().line();
  }
}

TEST(Determinism, holds_for_any_number_of_workers) {
  const auto hashes = [](Result<scene::SceneDesc> scene, unsigned workers) {
    ScenarioRun run(std::move(scene), workers);
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
