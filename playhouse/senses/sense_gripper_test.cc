#include <gtest/gtest.h>

#include <string>

#include "playhouse/stage/engine.h"
#include "playhouse/stage/testing_scenes.h"
#include "playhouse/world/gripper.h"

namespace playhouse::senses {
namespace {

using stage::testing::add_gripper;
using stage::testing::box;
using stage::testing::puck;
using world::GripperCommand;
using world::ModelId;

/// A gripper at the origin that looks along +x: 0.2 m long, its paddles 0.24 m apart, its beams 0.001 and
/// 0.067 m ahead of its middle.
scene::SceneDesc bench() {
  scene::SceneDesc scene;
  add_gripper(scene, "g", -1, {0, 0, 0, 0});
  return scene;
}

std::unique_ptr<world::Engine> engine_of(const scene::SceneDesc& scene, unsigned workers = 1) {
  auto engine = stage::make_engine(scene, {.seed = 1, .workers = workers});
  EXPECT_TRUE(engine.ok()) << engine.error().line();
  return std::move(*engine);
}

std::uint32_t beams_with(const scene::ModelDesc& thing) {
  scene::SceneDesc scene = bench();
  scene.models.push_back(thing);
  const auto engine = engine_of(scene);
  engine->step();
  EXPECT_EQ(engine->world().grippers.measured_tick[{0}], 1u);
  return engine->world().grippers.beams[{0}];
}

TEST(GripperSense, tells_which_beams_are_broken) {
  EXPECT_EQ(beams_with(puck({0.3, 0, 0, 0})), 0u);
  EXPECT_EQ(beams_with(puck({0.08, 0, 0, 0})), 2u);
  EXPECT_EQ(beams_with(puck({0.035, 0.07, 0, 0})), 3u);
  EXPECT_EQ(beams_with(puck({0, 0, 0, 0})), 1u);
  EXPECT_EQ(beams_with(puck({0.08, 0.17, 0, 0})), 0u) << "outside of the left paddle's inner face";
}

TEST(GripperSense, tells_beams_that_begin_or_end_in_a_thing) {
  EXPECT_EQ(beams_with(puck({0.08, 0.11, 0, 0})), 2u);
  EXPECT_EQ(beams_with(puck({0.08, -0.11, 0, 0})), 2u);
}

TEST(GripperSense, sees_things_for_grippers_alone_between_its_bottom_and_its_top) {
  scene::ModelDesc thing = puck({0.08, 0, 0.19, 0});
  EXPECT_EQ(beams_with(thing), 2u);
  thing.X_PM.z = 0.21;
  EXPECT_EQ(beams_with(thing), 0u);
  thing.X_PM.z = -0.11;
  EXPECT_EQ(beams_with(thing), 0u);
  thing.X_PM.z = 0;
  thing.gripper_return = false;
  EXPECT_EQ(beams_with(thing), 0u);
}

TEST(GripperSense, takes_a_gripper_for_a_thing_but_not_its_own) {
  scene::SceneDesc scene = bench();
  scene.models[0].gripper_return = true;
  auto engine = engine_of(scene);
  world::command_gripper(engine->world(), {0}, GripperCommand::kClose);
  for (int k = 0; k < 20; ++k) engine->step();
  EXPECT_EQ(engine->world().grippers.paddles[{0}], 1);
  EXPECT_EQ(engine->world().grippers.contacts[{0}], 0u);
  scene.models.push_back(scene.models[0]);
  scene.models[1].name = scene.models[1].alias = "h";
  scene.models[1].X_PM = {0.13, 0.2, 0, 0};
  engine = engine_of(scene);
  engine->step();
  EXPECT_EQ(engine->world().grippers.beams[{0}], 2u);
}

TEST(GripperSense, feels_on_which_side_something_is) {
  const auto contacts_with = [](double y) {
    scene::SceneDesc scene = bench();
    scene.models.push_back(puck({0.05, y, 0, 0}));
    const auto engine = engine_of(scene);
    engine->step();
    return engine->world().grippers.contacts[{0}];
  };
  EXPECT_EQ(contacts_with(0.1), 1u);
  EXPECT_EQ(contacts_with(-0.1), 2u);
  EXPECT_EQ(contacts_with(0), 0u);
}

/// Closes, and opens again; whether something was held in between.
bool grips(world::Engine& engine) {
  world::World& world = engine.world();
  world::command_gripper(world, {0}, GripperCommand::kClose);
  for (int k = 0; k < 22; ++k) engine.step();
  const bool held = world::held_by(world, {0}).index != world::ModelRow::kNone;
  world::command_gripper(world, {0}, GripperCommand::kOpen);
  for (int k = 0; k < 22; ++k) engine.step();
  return held;
}

TEST(GripperSense, what_was_put_down_can_be_taken_up_again) {
  scene::SceneDesc scene = bench();
  scene.models.push_back(puck({0.06, 0.03, 0, 0.3}));
  const auto engine = engine_of(scene);
  EXPECT_TRUE(grips(*engine));
  EXPECT_EQ(engine->world().models.X_WM[{1}], geom::Pose{}) << "where the gripper is";
  EXPECT_TRUE(grips(*engine));
}

TEST(GripperSense, takes_up_what_is_longer_than_its_paddles) {
  scene::SceneDesc scene = bench();
  scene.models.push_back(box("beam", {0.2, 0, 0, 0}, {0.5, 0.05, 0.1}));
  scene.models.back().gripper_return = true;
  EXPECT_TRUE(grips(*engine_of(scene)));
}

TEST(GripperSense, closes_on_nothing_where_nothing_is_loose) {
  scene::SceneDesc scene = bench();
  scene.models.push_back(stage::testing::robot("r", {0.06, 0, 0, 0}, {0.08, 0.08, 0.2}));
  scene.models.back().gripper_return = true;
  EXPECT_FALSE(grips(*engine_of(scene)));
}

TEST(GripperSense, looks_where_its_origin_puts_it) {
  scene::SceneDesc scene = bench();
  scene.models[0].X_MB = {1, 0, 0, geom::kPi / 2};
  scene.models.push_back(puck({1, 0.08, 0, 0}));
  const auto engine = engine_of(scene);
  engine->step();
  EXPECT_EQ(engine->world().grippers.beams[{0}], 2u);
}

/// A robot with a gripper that takes a puck along while it drives in a circle.
TEST(GripperSense, what_a_robot_holds_comes_along_and_is_seen_and_left_where_it_opens) {
  scene::SceneDesc scene;
  scene.models.push_back(stage::testing::robot("r", {0, 0, 0, 0}, {0.4, 0.4, 0.2}));
  add_gripper(scene, "r.gripper:0", 0, {0.3, 0, 0, 0});
  scene.models.push_back(puck({0.36, 0, 0, 0}));
  const auto engine = engine_of(scene);
  world::World& world = engine->world();
  const auto step = [&](int ticks) {
    for (int k = 0; k < ticks; ++k) engine->step();
  };
  world::command_gripper(world, {0}, GripperCommand::kClose);
  step(22);
  world::command_velocity(world, {0}, {0.5, 0, 0, 0.3});
  step(30);
  const geom::Pose at = world.models.X_WM[{2}];
  EXPECT_GT(at.x * at.x + at.y * at.y, 1);
  EXPECT_EQ(at, world.models.X_WM[{1}]);
  EXPECT_EQ(world.positions.stall[{0}], 0);
  world::command_velocity(world, {0}, {});
  world::command_gripper(world, {0}, GripperCommand::kOpen);
  step(1);
  EXPECT_EQ(world.models.parent_id[{2}], ModelId{});
  world::command_velocity(world, {0}, {-0.5, 0, 0, 0});
  step(20);
  EXPECT_EQ(world.models.X_WM[{2}], at);
  EXPECT_EQ(world.positions.stall[{0}], 0) << "it may drive away from what it put down";
  EXPECT_LT(world.models.X_WM[{0}].x, at.x - 0.8);
}

TEST(GripperSense, robots_that_close_in_on_each_others_pucks_do_the_same_with_any_number_of_workers) {
  scene::SceneDesc scene;
  for (int k = 0; k < 40; ++k) {
    const int robot = static_cast<int>(scene.models.size());
    const std::string name = "r" + std::to_string(k);
    const geom::Pose X_WM{0.5 * (k % 8), 0.8 * (k / 8), 0, 0.7 * k};
    scene.models.push_back(stage::testing::robot(name, X_WM, {0.2, 0.2, 0.2}));
    scene.models.back().position->velocity = {0.2, 0, 0, 0.3 - 0.01 * k};
    add_gripper(scene, name + ".gripper:0", robot, {0.2, 0, 0, 0});
    scene.models.back().gripper->autosnatch = true;
  }
  for (int k = 0; k < 60; ++k) scene.models.push_back(puck({0.07 * k - 0.2, 0.11 * (k % 30), 0, 0.2 * k}));
  const auto one = engine_of(scene, 1), three = engine_of(scene, 3);
  std::size_t taken = 0;
  for (int k = 0; k < 80; ++k) {
    one->step();
    three->step();
    for (const world::Event& event : one->world().events.since(0))
      taken += event.kind == world::Event::EventKind::kAttach ? 1 : 0;
    ASSERT_EQ(one->world().hash(), three->world().hash()) << k;
    ASSERT_EQ(one->world().sensed_hash(), three->world().sensed_hash()) << k;
  }
  EXPECT_GT(taken, 5u);
}

}  // namespace
}  // namespace playhouse::senses
