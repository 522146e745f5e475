// What presses the switches of a bumper, and that Stage's were pressed when these are.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/base/testing/reference.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/stage/engine.h"
#include "playhouse/stage/testing_scenes.h"

namespace playhouse::senses {
namespace {

using stage::testing::box;
using ::testing::ElementsAre;

/// A robot 0.4 m long and wide at the origin, with a switch of 0.3 m at each of these places.
scene::SceneDesc robot_with(std::vector<geom::Pose> X_BS) {
  scene::SceneDesc scene;
  scene.models.push_back(stage::testing::robot("robot", {}, {0.4, 0.4, 0.3}));
  scene::ModelDesc& model = scene.models.emplace_back();
  model.name = model.alias = "bumper";
  model.parent = 0;
  model.kind = scene::ModelKind::kBumper;
  model.alwayson = true;
  model.bumper.emplace();
  model.bumper->blength.assign(X_BS.size(), 0.3);
  model.bumper->X_BS = std::move(X_BS);
  return scene;
}

/// The same with one switch, 0.05 m before the robot.
scene::SceneDesc robot_with_one() {
  return robot_with({{0.25, 0, 0, 0}});
}

/// The names of those who press, "" for a switch that is free.
std::vector<std::string> pressed_in(const world::World& world) {
  std::vector<std::string> names;
  for (const world::ModelId hit : world.bumpers.hits[{0}])
    names.push_back(hit ? world.name(world.row(hit)) : "");
  return names;
}

std::vector<std::string> pressed_in(const scene::SceneDesc& scene, unsigned workers = 1) {
  auto engine = stage::make_engine(scene, {.seed = 1, .workers = workers});
  EXPECT_TRUE(engine.ok());
  (*engine)->step();
  EXPECT_EQ((*engine)->world().bumpers.measured_tick[{0}], 1u);
  return pressed_in((*engine)->world());
}

TEST(BumperSense, is_pressed_by_an_outline_across_its_face) {
  for (const double y : {-0.16, 0.0, 0.14}) {
    scene::SceneDesc scene = robot_with_one();
    scene.models.push_back(box("post", {0.25, y, 0, 0.3}, {0.04, 0.04, 1}));
    EXPECT_THAT(pressed_in(scene), ElementsAre("post")) << y;
  }
  for (const double y : {-0.18, 0.18}) {
    scene::SceneDesc scene = robot_with_one();
    scene.models.push_back(box("post", {0.25, y, 0, 0}, {0.04, 0.04, 1}));
    EXPECT_THAT(pressed_in(scene), ElementsAre("")) << y;
  }
}

TEST(BumperSense, is_pressed_by_what_it_touches_and_by_nothing_before_it) {
  scene::SceneDesc scene = robot_with_one();
  scene.models.push_back(box("wall", {0.35, 0, 0, 0}, {0.2, 2, 1}));
  EXPECT_THAT(pressed_in(scene), ElementsAre("wall"));
  scene.models.back().X_PM.x += 0.001;
  EXPECT_THAT(pressed_in(scene), ElementsAre(""));
  scene.models.push_back(box("beside", {0.25, 0.25, 0, 0}, {0.1, 0.2, 1}));
  EXPECT_THAT(pressed_in(scene), ElementsAre("beside"));
  scene.models.back().X_PM = {0.25, -0.25, 0, 0};
  EXPECT_THAT(pressed_in(scene), ElementsAre("beside"));
}

TEST(BumperSense, is_pressed_by_a_wall_that_its_whole_face_is_in_and_free_within_a_room) {
  scene::SceneDesc scene = robot_with_one();
  scene.models.push_back(box("wall", {0.32, 0, 0, 0}, {0.2, 2, 1}));
  EXPECT_THAT(pressed_in(scene), ElementsAre("wall"));
  scene.models.back() = box("room", {}, {5, 5, 1});
  EXPECT_THAT(pressed_in(scene), ElementsAre(""));
}

TEST(BumperSense, is_pressed_by_bodies_of_any_height_and_any_return) {
  scene::SceneDesc scene = robot_with_one();
  scene.models.push_back(box("lintel", {0.25, 0.1, 2, 0}, {0.04, 0.04, 1}));
  scene.models.back().obstacle_return = false;
  scene.models.back().ranger_return = -1;
  EXPECT_THAT(pressed_in(scene), ElementsAre("lintel"));
}

TEST(BumperSense, is_free_over_what_a_robot_may_stand_on) {
  scene::SceneDesc scene = robot_with_one();
  scene.models.push_back(box("mat", {0.1, 0, 0, 0}, {0.04, 0.04, 0.01}));
  scene.models.back().obstacle_return = false;
  EXPECT_THAT(pressed_in(scene), ElementsAre(""));
}

TEST(BumperSense, feels_with_each_of_its_switches_where_that_is_and_looks) {
  scene::SceneDesc scene =
      robot_with({{0.25, 0, 0, 0}, {0, 0.25, 0, geom::kPi / 2}, {-0.25, 0, 0, geom::kPi}});
  scene.models.push_back(box("post", {-0.1, 0.25, 0, 0}, {0.04, 0.04, 1}));
  EXPECT_THAT(pressed_in(scene), ElementsAre("", "post", ""));
  scene.models[1].X_PM.a = geom::kPi / 2;
  EXPECT_THAT(pressed_in(scene), ElementsAre("post", "", ""));
  scene.models[1].X_PM.a = 0;
  scene.models[1].bumper->blength[1] = 0.1;
  EXPECT_THAT(pressed_in(scene), ElementsAre("", "", ""));
}

TEST(BumperSense, is_not_pressed_by_its_own_robot) {
  scene::SceneDesc scene = robot_with({{0.1, 0, 0, 0}, {0.2, 0.2, 0, 0}});
  EXPECT_THAT(pressed_in(scene), ElementsAre("", ""));
  scene.models.push_back(stage::testing::robot("other", {0.45, 0.3, 0, 0}, {0.4, 0.4, 0.3}));
  EXPECT_THAT(pressed_in(scene), ElementsAre("", ""));
  scene.models.back().X_PM.x = 0.4;
  EXPECT_THAT(pressed_in(scene), ElementsAre("", "other"));
}

TEST(BumperSense, feels_the_same_with_any_number_of_workers) {
  std::vector<geom::Pose> X_BS;
  for (int k = 0; k < 40; ++k) {
    const double a = k * geom::kTwoPi / 40;
    const geom::SinCos sc = geom::sincos(a);
    X_BS.push_back({0.3 * sc.cos, 0.3 * sc.sin, 0, geom::normalize(a)});
  }
  scene::SceneDesc scene = robot_with(std::move(X_BS));
  scene.models.push_back(box("wall", {0.35, 0.1, 0, 0.2}, {0.2, 0.5, 1}));
  const std::vector<std::string> pressed = pressed_in(scene, 1);
  EXPECT_GT(std::ranges::count(pressed, "wall"), 3);
  EXPECT_GT(std::ranges::count(pressed, ""), 20);
  EXPECT_EQ(pressed, pressed_in(scene, 3));
}

// Stage: {"t":0.500000,...,"gpose":[0.250000000,...],...,"d.bumper:0":[1,0]}, the front one from there on.
// Decided: touching is free, so this robot comes 0.05 m nearer, and the switch stays pressed.
TEST(BumperSense, is_pressed_when_stages_was) {
  const auto scene = scene::load_world((reference() / "stage/traces/bumper.world").string());
  ASSERT_TRUE(scene.ok()) << scene.error().line();
  auto engine = stage::make_engine(*scene, {});
  ASSERT_TRUE(engine.ok());
  world::World& world = (*engine)->world();
  for (const world::ModelRow row : world.models.rows()) world::subscribe(world, row);
  ASSERT_TRUE(world::command_velocity(world, {0}, {0.5, 0, 0, 0}));
  const bool recorded[] = {false, false, false, false, true, true, true, true};
  for (const bool front : recorded) {
    (*engine)->step();
    EXPECT_THAT(pressed_in(world), ElementsAre(front ? "w" : "", "")) << world.time();
  }
  EXPECT_NEAR(world.models.X_WM[{0}].x, 0.3, 1e-9);
  EXPECT_EQ(world.positions.stall[{0}], 1);
}

}  // namespace
}  // namespace playhouse::senses
