#include "playhouse/controllers/fasr.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "playhouse/controllers/attach.h"
#include "playhouse/controllers/testing/scenes.h"
#include "playhouse/world/population/population.h"

namespace playhouse::controllers {
namespace {

using ::testing::EndsWith;

/// Robots with a scanner 2 m apart along x, each with `ctrl`, and behind their rows a source at their first
/// and a sink at (20, 0).
struct Field {
  explicit Field(const std::string& ctrl, std::size_t robots = 2)
      : scene(made(ctrl, robots)), world(scene, 7) {
    const auto attached = attach(world, {});
    if (!attached) error = attached.error().line();
    source = world.find("source");
    sink = world.find("sink");
  }
  static scene::SceneDesc made(const std::string& ctrl, std::size_t robots) {
    scene::SceneDesc scene = testing::robots(robots, testing::scanner(9), ctrl);
    for (const auto& [name, x] : {std::pair("source", 0.0), std::pair("sink", 20.0)}) {
      scene::ModelDesc& end = scene.models.emplace_back();
      end.name = end.alias = name;
      end.X_PM.x = x;
    }
    return scene;
  }
  std::int32_t& flags(world::ModelRow model) { return world.models.flags[model]; }
  world::ModelRow robot(std::uint32_t k) const { return {2 * k}; }
  const geom::Twist& command(std::uint32_t robot) const { return world.positions.command[{robot}]; }
  /// A scan in which nothing is near, and a decision.
  void decide() {
    testing::measure(world, {8.0f});
    testing::decide(world);
  }

  scene::SceneDesc scene;
  world::World world;
  std::string error;
  world::ModelRow source, sink;
};

TEST(Fasr, takes_a_flag_within_two_metres_of_the_source) {
  Field f("fasr");
  ASSERT_EQ(f.error, "");
  f.flags(f.source) = 5;
  world::set_pose(f.world, f.robot(0), {1.9, 0, 0, 0});
  world::set_pose(f.world, f.robot(1), {2.1, 0, 0, 0});
  f.decide();
  EXPECT_EQ(f.flags(f.robot(0)), 1);
  EXPECT_EQ(f.flags(f.robot(1)), 0);
  EXPECT_EQ(f.flags(f.source), 4);
  f.decide();
  EXPECT_EQ(f.flags(f.robot(0)), 1) << "one at a time";
}

TEST(Fasr, gives_its_flag_within_a_metre_of_the_sink) {
  Field f("fasr");
  for (const std::uint32_t k : {0u, 1u}) f.flags(f.robot(k)) = 1;
  world::set_pose(f.world, f.robot(0), {19.1, 0, 0, 0});
  world::set_pose(f.world, f.robot(1), {18.9, 0, 0, 0});
  f.decide();
  EXPECT_EQ(f.flags(f.robot(0)), 0);
  EXPECT_EQ(f.flags(f.robot(1)), 1);
  EXPECT_EQ(f.flags(f.sink), 1);
}

TEST(Fasr, of_the_lowest_id_gets_the_last_flag) {
  Field f("fasr", 3);
  f.flags(f.source) = 1;
  for (const std::uint32_t k : {0u, 1u, 2u}) world::set_pose(f.world, f.robot(k), {0.5 * k, 1, 0, 0});
  testing::measure(f.world, {8.0f});
  for (const auto& decider : f.world.deciders) decider->follow(f.world);
  world::Decider& fasr = *f.world.deciders[0];
  fasr.decide(f.world, 2, 3);
  fasr.decide(f.world, 0, 2);
  fasr.deliver(f.world);
  EXPECT_EQ(f.flags(f.robot(0)), 1);
  EXPECT_EQ(f.flags(f.robot(1)) + f.flags(f.robot(2)) + f.flags(f.source), 0);
}

TEST(Fasr, drives_to_the_source_without_a_flag_and_to_the_sink_with_one) {
  Field f("fasr", 1);
  world::set_pose(f.world, f.robot(0), {10, 0, 0, geom::kPi / 2});
  f.decide();
  EXPECT_GT(f.command(0).a, 0.5) << "the source is to the left";
  f.flags(f.robot(0)) = 1;
  f.decide();
  EXPECT_LT(f.command(0).a, -0.5);
}

TEST(Fasr, gets_away_from_what_it_stands_against) {
  Field f("fasr", 1);
  world::set_pose(f.world, f.robot(0), {10, 0, 0, geom::kPi});
  f.world.positions.stall[{0}] = 1;
  f.decide();
  EXPECT_EQ(std::fabs(f.command(0).x), 0.2);
  f.world.positions.stall[{0}] = 0;
  const geom::Twist away = f.command(0);
  for (int scan = 0; scan < 7; ++scan) f.decide();
  EXPECT_EQ(f.command(0), away) << "for eight scans at least";
  for (int scan = 0; scan < 20; ++scan) f.decide();
  EXPECT_EQ(f.command(0).x, 0.4);
}

TEST(Fasr, wanders_where_an_end_has_gone) {
  Field f("fasr", 1);
  world::set_pose(f.world, f.robot(0), {10, 0, 0, geom::kPi / 2});
  ASSERT_TRUE(world::despawn(f.world, f.world.id(f.sink)).ok());
  f.decide();
  EXPECT_EQ(f.command(0), (geom::Twist{0.4, 0, 0, 0}));
}

TEST(Fasr, goes_where_its_arguments_say) {
  Field f("fasr sink source", 1);
  ASSERT_EQ(f.error, "");
  f.flags(f.sink) = 1;
  world::set_pose(f.world, f.robot(0), {20, 1, 0, 0});
  f.decide();
  EXPECT_EQ(f.flags(f.robot(0)), 1);
}

TEST(Fasr2, takes_up_its_tasks_and_says_that_it_waits) {
  scene::SceneDesc scene = Field::made("fasr2 red green", 40);
  scene.models[scene.models.size() - 2].name = "red_source";
  scene.models.back().name = "red_sink";
  for (const auto& [name, x] : {std::pair("green_source", 0.0), std::pair("green_sink", 20.0)}) {
    scene::ModelDesc& end = scene.models.emplace_back();
    end.name = end.alias = name;
    end.X_PM = {x, 10, 0, 0};
  }
  world::World world(scene, 7);
  ASSERT_TRUE(attach(world, {}));
  const world::ModelRow red = world.find("red_source"), green = world.find("green_source");
  world.models.flags[red] = world.models.flags[green] = 100;
  const auto round = [&](double y) {
    for (const world::ModelRow robot : world.positions.model) world::set_pose(world, robot, {0, y, 0, 0});
    testing::measure(world, {8.0f});
    testing::decide(world);
  };
  const auto others = [&](const std::string& text) {
    return std::ranges::count_if(world.positions.model,
                                 [&](world::ModelRow robot) { return world.models.say[robot] == text; });
  };
  round(0);
  const std::int32_t of_red = 100 - world.models.flags[red];
  EXPECT_GT(of_red, 5);
  EXPECT_LT(of_red, 35);
  EXPECT_EQ(world.models.flags[green], 100);
  world.models.flags[green] = 0;
  round(10);
  EXPECT_EQ(others("Waiting..."), 40 - of_red);
  world.models.flags[green] = 100;
  round(10);
  EXPECT_EQ(others("Waiting..."), 0);
  EXPECT_EQ(100 - world.models.flags[green], 40 - of_red);
}

TEST(Fasr2, needs_the_ends_of_every_task) {
  EXPECT_THAT(Field("fasr2 red").error, EndsWith("needs a model \"red_source\""));
}

TEST(Fasr, needs_both_ends_and_a_scanner) {
  EXPECT_THAT(Field("fasr depot").error, EndsWith("controller \"fasr\" of \"r0\": needs a model \"depot\""));
  scene::SceneDesc scene = Field::made("fasr", 1);
  scene.models[1].sensors.clear();
  world::World world(scene, 7);
  const auto attached = attach(world, {});
  ASSERT_FALSE(attached);
  EXPECT_THAT(attached.error().line(), EndsWith("needs a ranger with at least one sensor"));
}

}  // namespace
}  // namespace playhouse::controllers
