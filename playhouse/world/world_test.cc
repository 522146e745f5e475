#include "playhouse/world/world.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

#include "playhouse/world/workers.h"

namespace playhouse::world {
namespace {

/// A robot "r" at (1, 2, 90 degrees) with a two-beam ranger 0.1 m ahead of it, and a box "box".
scene::SceneDesc small_scene() {
  scene::SceneDesc scene;
  scene::ModelDesc robot;
  robot.name = "r";
  robot.alias = "position:0";
  robot.kind = scene::ModelKind::kPosition;
  robot.X_PM = {1, 2, 0, geom::kPi / 2};
  robot.position.emplace();
  scene::ModelDesc ranger;
  ranger.name = "r.ranger:0";
  ranger.alias = ranger.name;
  ranger.kind = scene::ModelKind::kRanger;
  ranger.parent = 0;
  ranger.X_PM = {0.1, 0, 0.2, 0};
  ranger.sensors.resize(1);
  ranger.sensors[0].samples = 2;
  scene::ModelDesc box;
  box.name = "box";
  box.alias = "model:1";
  scene.models = {robot, ranger, box};
  return scene;
}

TEST(World, finds_models_by_name_and_by_default_name) {
  const scene::SceneDesc scene = small_scene();
  const World world(scene, 1);
  EXPECT_EQ(world.find("r"), ModelRow{0});
  EXPECT_EQ(world.find("position:0"), ModelRow{0});
  EXPECT_EQ(world.find("model:1"), ModelRow{2});
  EXPECT_FALSE(world.find("nobody").valid());
  ASSERT_EQ(world.children({0}).size(), 1u);
  EXPECT_EQ(world.children({0})[0], 1u);
  EXPECT_EQ(world.models.root[1], 0u);
}

TEST(World, of_equal_names_the_last_wins_and_a_given_name_beats_a_default_one) {
  scene::SceneDesc scene = small_scene();
  scene.models[0].name = "model:1";
  scene.models[1].name = "same";
  scene.models[2].name = "same";
  const World world(scene, 1);
  EXPECT_EQ(world.find("same"), ModelRow{2});
  EXPECT_EQ(world.find("model:1"), ModelRow{0});
}

TEST(World, children_follow_when_their_parent_is_put_elsewhere) {
  const scene::SceneDesc scene = small_scene();
  World world(scene, 1);
  EXPECT_NEAR(world.models.X_WM[1].x, 1.0, 1e-12);
  EXPECT_NEAR(world.models.X_WM[1].y, 2.1, 1e-12);
  EXPECT_NEAR(world.models.X_WM[1].z, 0.2, 1e-12);
  ASSERT_TRUE(set_pose(world, {0}, {-1, 0, 0, 0}));
  EXPECT_NEAR(world.models.X_WM[1].x, -0.9, 1e-12);
  EXPECT_NEAR(world.models.X_WM[1].y, 0, 1e-12);
  ASSERT_EQ(world.teleported.size(), 1u);
  EXPECT_NEAR(world.positions.X_OM[0].x, -1, 1e-12);
}

TEST(World, gps_without_an_origin_is_the_true_pose_and_odometry_starts_at_zero) {
  scene::SceneDesc scene = small_scene();
  EXPECT_NEAR(World(scene, 1).positions.X_OM[0].y, 2, 1e-12);
  scene.models[0].position->localization_origin = geom::Pose{1, 0, 0, 0};
  EXPECT_NEAR(World(scene, 1).positions.X_OM[0].x, 0, 1e-12);
  EXPECT_NEAR(World(scene, 1).positions.X_OM[0].y, 2, 1e-12);
  scene.models[0].position->localization_origin.reset();
  scene.models[0].position->localization = scene::Localization::kOdometry;
  EXPECT_NEAR(World(scene, 1).positions.X_OM[0].y, 0, 1e-12);
}

TEST(World, a_robot_told_where_it_is_believes_it_also_after_it_was_moved) {
  const scene::SceneDesc scene = small_scene();
  World world(scene, 1);
  ASSERT_TRUE(set_odometry(world, {0}, {5, 6, 0, 0}));
  EXPECT_EQ(world.positions.X_OM[0].x, 5);
  ASSERT_TRUE(set_pose(world, {0}, {1, 3, 0, geom::kPi / 2}));  // a metre ahead
  EXPECT_NEAR(world.positions.X_OM[0].x, 6, 1e-12);
  EXPECT_NEAR(world.positions.X_OM[0].y, 6, 1e-12);
}

TEST(World, refuses_numbers_that_are_not_finite) {
  const scene::SceneDesc scene = small_scene();
  World world(scene, 1);
  const std::uint64_t before = world.hash();
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(command_velocity(world, {0}, {nan, 0, 0, 0}));
  EXPECT_FALSE(command_position(world, {0}, {0, infinite, 0, 0}));
  EXPECT_FALSE(command_acceleration(world, {0}, {0, 0, 0, nan}));
  EXPECT_FALSE(set_odometry(world, {0}, {nan, 0, 0, 0}));
  EXPECT_FALSE(set_pose(world, {0}, {0, 0, infinite, 0}));
  EXPECT_EQ(world.hash(), before);
}

TEST(World, refuses_places_whose_distance_is_no_number) {
  const scene::SceneDesc scene = small_scene();
  World world(scene, 1);
  const std::uint64_t before = world.hash();
  for (const geom::Pose& far : {geom::Pose{1e308, 0, 0, 0}, {0, -1e308, 0, 0}, {0, 0, 2e9, 0}}) {
    EXPECT_FALSE(command_position(world, {0}, far));
    EXPECT_FALSE(set_odometry(world, {0}, far));
    EXPECT_FALSE(set_pose(world, {0}, far));
  }
  EXPECT_EQ(world.hash(), before);
  EXPECT_TRUE(set_pose(world, {0}, {-1e9, 1e9, 0, 1e300})) << "any angle is one";
}

TEST(World, returns_to_its_start_but_keeps_its_time_and_users) {
  const scene::SceneDesc scene = small_scene();
  World world(scene, 1);
  const std::uint64_t start = world.hash();
  subscribe(world, {0});
  world.tick_ = 7;
  ASSERT_TRUE(set_pose(world, {0}, {5, 5, 0, 1}));
  ASSERT_TRUE(set_pose(world, {1}, {0.2, 0, 0.2, 1}));
  ASSERT_TRUE(command_velocity(world, {0}, {1, 0, 0, 1}));
  ASSERT_TRUE(set_odometry(world, {0}, {9, 9, 0, 0}));
  world.positions.motor_on[0] = 0;
  world.teleported.clear();
  return_to_start(world);
  EXPECT_EQ(world.teleported, (std::vector<ModelRow>{{0}, {1}}));
  EXPECT_EQ(world.tick(), 7u);
  EXPECT_EQ(world.models.subscribers[0], 1u);
  unsubscribe(world, {0});
  world.tick_ = 0;
  EXPECT_EQ(world.hash(), start);
}

TEST(World, the_last_unsubscribe_stops_the_robot) {
  const scene::SceneDesc scene = small_scene();
  World world(scene, 1);
  subscribe(world, {0});
  subscribe(world, {0});
  ASSERT_TRUE(command_velocity(world, {0}, {0.5, 0, 0, 0}));
  unsubscribe(world, {0});
  EXPECT_EQ(world.positions.command[0].x, 0.5);
  unsubscribe(world, {0});
  EXPECT_EQ(world.positions.command[0].x, 0.0);
}

TEST(World, the_odometry_error_is_drawn_per_robot_from_the_seed) {
  const scene::SceneDesc scene = small_scene();
  const geom::Twist first = World(scene, 1).positions.odom_error[0];
  EXPECT_EQ(first, World(scene, 1).positions.odom_error[0]);
  EXPECT_NE(first, World(scene, 2).positions.odom_error[0]);
  EXPECT_LE(std::fabs(first.x), 0.015);
  EXPECT_LE(std::fabs(first.a), 0.025);
}

TEST(World, the_hash_sees_every_kind_of_column) {
  const scene::SceneDesc scene = small_scene();
  const std::uint64_t before = World(scene, 1).hash();
  EXPECT_EQ(before, World(scene, 1).hash());
  const auto changed = [&](auto change) {
    World world(scene, 1);
    change(world);
    return world.hash() != before;
  };
  EXPECT_TRUE(changed([](World& w) { w.sensors.ranges[1] = 4; }));
  EXPECT_TRUE(changed([](World& w) { w.models.flags[2] = 1; }));
  EXPECT_TRUE(changed([](World& w) { w.positions.stall[0] = 1; }));
  EXPECT_TRUE(changed([](World& w) { set_color(w, {2}, {0, 0, 1, 1}); }));
  EXPECT_TRUE(changed([](World& w) { set_fiducial_return(w, {2}, 3); }));
  EXPECT_TRUE(changed([](World& w) { w.models.say[0] = "hello"; }));
  EXPECT_TRUE(changed([](World& w) { w.tick_ = 1; }));
}

TEST(Workers, cover_every_row_once) {
  for (const unsigned count : {1u, 2u, 4u}) {
    Workers workers(count);
    std::vector<int> touched(1001, 0);
    std::atomic<bool> numbered = true;
    workers.run(touched.size(), 10, [&](std::size_t begin, std::size_t end) {
      if (workers.current() >= workers.count()) numbered = false;
      for (std::size_t i = begin; i < end; ++i) ++touched[i];
    });
    EXPECT_TRUE(numbered);
    EXPECT_EQ(touched, std::vector<int>(1001, 1));
  }
}

}  // namespace
}  // namespace playhouse::world
