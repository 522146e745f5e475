/// How whole populations behave in worlds of Stage, against what the same populations do in Stage 4.3: the
/// figures of tests/reference/stage/behaviour.md. docs/stage-compatibility.md ("Populations") has both.

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "playhouse/base/testing/reference.h"
#include "playhouse/scenarios/testing_simulation.h"

namespace playhouse::scenarios {
namespace {

using testing::ScenarioRun;

struct Population {
  double speed = 0;       // m/s, mean over robots and time
  double stall = 0;       // share of robot-time with the stall flag
  double moving = 0;      // share of half seconds in which a robot came to another place
  std::size_t cells = 0;  // of 0.5 m, that some robot visited
};

Population observe(ScenarioRun& run, double seconds) {
  const world::World& world = run.world();
  const world::Positions& robots = world.positions;
  constexpr double kHalfSecond = 0.5, kCell = 0.5;
  const int window = static_cast<int>(kHalfSecond / world.scene().interval + 0.5);
  const int windows = static_cast<int>(seconds / kHalfSecond + 0.5);
  const auto place = [&](world::PositionRow i) { return world.models.X_WM[robots.model[i]].xy(); };
  const auto way = [](geom::Vec2 a, geom::Vec2 b) { return std::sqrt(geom::dot(b - a, b - a)); };

  ByRow<world::PositionTable, geom::Vec2> last, at_window;
  for (const world::PositionRow i : robots.model.rows()) last.push_back(place(i));
  std::set<std::pair<int, int>> cells;
  double driven = 0, stalls = 0, moves = 0;
  for (int k = 0; k < windows; ++k) {
    at_window = last;
    for (int tick = 0; tick < window; ++tick) {
      run.step();
      for (const world::PositionRow i : robots.model.rows()) {
        const geom::Vec2 at = place(i);
        cells.insert(
            {static_cast<int>(std::floor(at.x / kCell)), static_cast<int>(std::floor(at.y / kCell))});
        driven += way(last[i], at);
        stalls += robots.stall[i];
        last[i] = at;
      }
    }
    for (const world::PositionRow i : robots.model.rows()) moves += way(at_window[i], last[i]) > 1e-3;
  }
  const auto count = static_cast<double>(robots.size());
  return {driven / (count * seconds), stalls / (count * windows * window), moves / (count * windows),
          cells.size()};
}

/// Holds every command back for a tick: in Stage 4.3 sensors show where bodies were a step earlier. For
/// robots whose controllers command them anew in every tick.
class OneTickLate final : public world::Decider {
 public:
  explicit OneTickLate(std::size_t robots) : held_(robots) {}
  std::string_view name() const override { return "one tick late"; }
  std::size_t size() const override { return held_.size(); }
  void follow(world::World&) override {}
  void decide(world::World& world, std::size_t begin, std::size_t end) override {
    for (const world::PositionRow i : held_.rows().part(begin, end))
      std::swap(world.positions.command[i], held_[i]);
  }
  void hash(const world::World&, Hash&) const override {}
  Result<void> save(Packer&) const override { return Error{{}, "is for tests"}; }
  bool load(world::World&, Unpacker&) override { return false; }

 private:
  ByRow<world::PositionTable, geom::Twist> held_;
};

void delay_as_stage_does(ScenarioRun& run) {
  run.world().deciders.push_back(std::make_unique<OneTickLate>(run.world().positions.size()));
}

std::string stage_world(const std::string& name) {
  return (stage_source() / "worlds" / name).string();
}

TEST(Populations, of_expand_swarm_spread_through_the_hospital_as_in_stage) {
  const std::string path = stage_world("benchmark/hospital.world");
  SKIP_WITHOUT_STAGE();
  ScenarioRun run(scene::load_world(path));
  ASSERT_EQ(run.world().positions.size(), 1000u);
  delay_as_stage_does(run);
  const Population seen = observe(run, 60);
  EXPECT_NEAR(seen.speed, 0.044, 0.1 * 0.044);
  EXPECT_NEAR(seen.stall, 0, 0.01);
  EXPECT_NEAR(seen.moving, 0.40, 0.04);
  EXPECT_NEAR(static_cast<double>(seen.cells), 1239, 0.1 * 1239);
}

TEST(Populations, of_expand_swarm_need_fewer_corrections_without_the_delay_of_stage) {
  const std::string path = stage_world("benchmark/hospital.world");
  SKIP_WITHOUT_STAGE();
  ScenarioRun run(scene::load_world(path));
  const Population seen = observe(run, 60);
  EXPECT_NEAR(seen.speed, 0.041, 0.05 * 0.041);
  EXPECT_NEAR(seen.moving, 0.32, 0.05 * 0.32);
  EXPECT_NEAR(static_cast<double>(seen.cells), 1163, 0.05 * 1163);
}

TEST(Populations, of_expand_pioneer_spread_through_the_cave_as_in_stage) {
  const std::string path = stage_world("benchmark/cave.world");
  SKIP_WITHOUT_STAGE();
  ScenarioRun run(scene::load_world(path));
  ASSERT_EQ(run.world().positions.size(), 100u);
  delay_as_stage_does(run);
  const Population seen = observe(run, 300);
  EXPECT_NEAR(seen.speed, 0.015, 0.15 * 0.015);
  EXPECT_NEAR(seen.stall, 0.015, 0.02);
  EXPECT_NEAR(seen.moving, 0.21, 0.03);
  EXPECT_NEAR(static_cast<double>(seen.cells), 403, 0.1 * 403);
}

TEST(Populations, of_wander_get_about_in_a_cave_with_walls_as_in_stage) {
  const std::string path = stage_world("benchmark/cave.world");
  SKIP_WITHOUT_STAGE();
  Result<scene::SceneDesc> scene = scene::load_world(path);
  ASSERT_TRUE(scene) << scene.error().line();
  for (scene::ModelDesc& model : scene->models) {
    if (model.name == "cave") model.obstacle_return = true;
    if (!model.ctrl.empty()) model.ctrl = {"wander"};
  }
  ScenarioRun run(std::move(scene));
  delay_as_stage_does(run);
  const Population seen = observe(run, 150);
  // Stage's own spread is 0.007 and 0.03; here robots that touch are free to turn away.
  EXPECT_NEAR(seen.speed, 0.084, 0.014);
  EXPECT_NEAR(seen.stall, 0.45, 0.12);
  EXPECT_NEAR(seen.moving, 0.55, 0.12);
  EXPECT_NEAR(static_cast<double>(seen.cells), 595, 0.1 * 595);
}

}  // namespace
}  // namespace playhouse::scenarios
