#include "playhouse/world/world.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "playhouse/world/population/population.h"
#include "playhouse/world/saving/state.h"
#include "playhouse/world/testing_scene.h"
#include "playhouse/world/workers.h"

namespace playhouse::world {
namespace {

using testing::small_scene;

TEST(World, finds_models_by_name_and_by_default_name) {
  const scene::SceneDesc scene = small_scene();
  const World world(scene, 1);
  EXPECT_EQ(world.find("r"), ModelRow{0});
  EXPECT_EQ(world.find("position:0"), ModelRow{0});
  EXPECT_EQ(world.find("model:1"), ModelRow{2});
  EXPECT_FALSE(world.find("nobody").valid());
  std::vector<ModelRow> children;
  for (const ModelRow child : world.children({0})) children.push_back(child);
  EXPECT_EQ(children, std::vector{ModelRow{1}});
  EXPECT_EQ(world.models.root[{1}], ModelRow{0});
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
  EXPECT_NEAR(world.models.X_WM[{1}].x, 1.0, 1e-12);
  EXPECT_NEAR(world.models.X_WM[{1}].y, 2.1, 1e-12);
  EXPECT_NEAR(world.models.X_WM[{1}].z, 0.2, 1e-12);
  ASSERT_TRUE(set_pose(world, {0}, {-1, 0, 0, 0}));
  EXPECT_NEAR(world.models.X_WM[{1}].x, -0.9, 1e-12);
  EXPECT_NEAR(world.models.X_WM[{1}].y, 0, 1e-12);
  ASSERT_EQ(world.events.since(0).size(), 1u);
  EXPECT_EQ(world.events.since(0)[0].kind, Event::EventKind::kPlace);
  EXPECT_EQ(world.events.since(0)[0].model, ModelId{0});
  EXPECT_NEAR(world.positions.X_OM[{0}].x, -1, 1e-12);
}

TEST(World, gps_without_an_origin_is_the_true_pose_and_odometry_starts_at_zero) {
  scene::SceneDesc scene = small_scene();
  EXPECT_NEAR(World(scene, 1).positions.X_OM[{0}].y, 2, 1e-12);
  scene.models[0].position->localization_origin = geom::Pose{1, 0, 0, 0};
  EXPECT_NEAR(World(scene, 1).positions.X_OM[{0}].x, 0, 1e-12);
  EXPECT_NEAR(World(scene, 1).positions.X_OM[{0}].y, 2, 1e-12);
  scene.models[0].position->localization_origin.reset();
  scene.models[0].position->localization = scene::Localization::kOdometry;
  EXPECT_NEAR(World(scene, 1).positions.X_OM[{0}].y, 0, 1e-12);
}

TEST(World, tilted_models_take_their_parts_along_in_space) {
  const scene::SceneDesc scene = small_scene();
  World world(scene, 1);
  world.upright = false;
  ASSERT_TRUE(set_spatial_pose(world, {0}, {{1, 2, 0.5, geom::kPi / 2}, {0, geom::kPi / 2}}));  // nose down
  EXPECT_NEAR(world.models.X_WM[{1}].x, 1, 1e-12);
  EXPECT_NEAR(world.models.X_WM[{1}].y, 2.2, 1e-12) << "what was above it is ahead";
  EXPECT_NEAR(world.models.X_WM[{1}].z, 0.4, 1e-12) << "what was ahead is below";
  EXPECT_NEAR(world.models.tilt_WM[{1}].y, geom::kPi / 2, 1e-12);
  ASSERT_TRUE(set_pose(world, {0}, {0, 0, 0, 0}));
  EXPECT_NEAR(world.models.X_WM[{1}].z, -0.1, 1e-12) << "it is as tilted as it was";
  return_to_start(world);
  EXPECT_EQ(world.models.X_WM[{1}], World(scene, 1).models.X_WM[{1}]);
  EXPECT_EQ(world.models.tilt_WM[{0}], geom::Tilt{});
}

TEST(World, what_comes_off_a_tilted_model_stays_as_it_stands) {
  scene::SceneDesc scene = small_scene();
  scene.models[2].gripper_return = true;
  World world(scene, 1);
  world.upright = false;
  ASSERT_TRUE(set_spatial_pose(world, {0}, {{0, 0, 1, 0}, {0.5, 0}}));
  ASSERT_TRUE(set_spatial_pose(world, {2}, {{5, 5, 0, 0}, {0, 1}}));
  ASSERT_TRUE(attach(world, {2}, {0}, {0, 0.3, 0, 0}));
  const geom::SpatialPose held = pose_in_world(world.models, {2});
  EXPECT_EQ(world.models.tilt_PM[{2}], geom::Tilt{}) << "it is put down flat";
  EXPECT_NEAR(held.tilt.x, 0.5, 1e-12);
  ASSERT_TRUE(detach(world, {2}));
  EXPECT_EQ(pose_in_parent(world.models, {2}), held);
}

TEST(World, of_an_engine_that_keeps_models_upright_has_no_tilts) {
  const scene::SceneDesc scene = small_scene();
  World upright(scene, 1), tilting(scene, 1);
  tilting.upright = false;
  const geom::SpatialPose X_WM{{1, 2, 3, 0.5}, {0.25, 0}};
  for (World* world : {&upright, &tilting}) ASSERT_TRUE(set_spatial_pose(*world, {0}, X_WM));
  EXPECT_EQ(pose_in_world(tilting.models, {0}), X_WM);
  EXPECT_EQ(pose_in_world(upright.models, {0}), (geom::SpatialPose{X_WM.X, {}}));
  std::vector<std::byte> saved;
  ASSERT_TRUE(save_state(tilting, saved));
  World other(scene, 1);
  other.upright = false;
  ASSERT_TRUE(load_state(other, saved));
  EXPECT_EQ(pose_in_world(other.models, {1}), pose_in_world(tilting.models, {1}));
  const Result<void> loaded = load_state(upright, saved);
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().text, "has models that are tilted, and this engine keeps all upright");
}

TEST(World, a_robot_told_where_it_is_believes_it_also_after_it_was_moved) {
  const scene::SceneDesc scene = small_scene();
  World world(scene, 1);
  ASSERT_TRUE(set_odometry(world, {0}, {5, 6, 0, 0}));
  EXPECT_EQ(world.positions.X_OM[{0}].x, 5);
  ASSERT_TRUE(set_pose(world, {0}, {1, 3, 0, geom::kPi / 2}));  // a metre ahead
  EXPECT_NEAR(world.positions.X_OM[{0}].x, 6, 1e-12);
  EXPECT_NEAR(world.positions.X_OM[{0}].y, 6, 1e-12);
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
  EXPECT_FALSE(set_spatial_pose(world, {0}, {{}, {nan, 0}}));
  EXPECT_FALSE(set_spatial_pose(world, {0}, {{}, {0, 4}}));
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
  world.positions.motor_on[{0}] = 0;
  const std::uint64_t before = world.events.end();
  return_to_start(world);
  const auto changes = world.events.since(before);
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_EQ(changes[0].model, ModelId{0});
  EXPECT_EQ(changes[1].model, ModelId{1});
  EXPECT_EQ(world.tick(), 7u);
  EXPECT_EQ(world.models.subscribers[{0}], 1u);
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
  EXPECT_EQ(world.positions.command[{0}].x, 0.5);
  unsubscribe(world, {0});
  EXPECT_EQ(world.positions.command[{0}].x, 0.0);
}

TEST(World, the_odometry_error_is_drawn_per_robot_from_the_seed) {
  const scene::SceneDesc scene = small_scene();
  const geom::Twist first = World(scene, 1).positions.odom_error[{0}];
  EXPECT_EQ(first, World(scene, 1).positions.odom_error[{0}]);
  EXPECT_NE(first, World(scene, 2).positions.odom_error[{0}]);
  EXPECT_LE(std::fabs(first.x), 0.015);
  EXPECT_LE(std::fabs(first.a), 0.025);
}

TEST(World, models_carry_neither_less_than_no_flag_nor_more_than_can_be_counted) {
  const scene::SceneDesc scene = small_scene();
  World world(scene, 1);
  add_flags(world, {1}, 3);
  add_flags(world, {1}, -1);
  EXPECT_EQ(world.models.flags[{1}], 2);
  add_flags(world, {1}, std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(world.models.flags[{1}], 0);
  add_flags(world, {1}, 5);
  add_flags(world, {1}, std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(world.models.flags[{1}], std::numeric_limits<std::int32_t>::max());
}

TEST(World, whoever_watches_changes_the_hash_of_what_is_sensed_alone) {
  const scene::SceneDesc scene = small_scene();
  World watched(scene, 1), alone(scene, 1);
  for (const std::uint32_t model : {0u, 1u}) subscribe(watched, {model});
  watched.sensors.ranges[{0}] = 2;
  watched.rangers.measured_tick[{0}] = 1;
  EXPECT_EQ(watched.hash(), alone.hash());
  EXPECT_NE(watched.sensed_hash(), alone.sensed_hash());
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
