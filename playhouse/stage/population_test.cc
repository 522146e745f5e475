/// Models that come, go and are carried while the engine runs: every table follows, and what is saved at any
/// tick goes on as what ran through.

#include "playhouse/world/population/population.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "playhouse/stage/engine.h"
#include "playhouse/stage/testing_scenes.h"
#include "playhouse/world/gripper.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::stage {
namespace {

using testing::box;
using testing::laser;
using testing::pioneer;
using testing::sonar_ring;
using world::ModelId;

/// Walls (rows 0 to 3), a robot with sonars and a laser (4 to 6), a puck (7), a robot with a fiducial finder
/// (8, 9).
scene::SceneDesc make_scene() {
  scene::SceneDesc scene;
  scene.name = "yard";
  testing::add_arena(scene, 8);
  scene.models.push_back(pioneer("r", {-2, 0, 0, 0}));
  scene.models.back().position->velocity = {0.3, 0, 0, 0.2};
  scene.models.push_back(sonar_ring("r.ranger:0", 4));
  scene.models.push_back(laser("r.ranger:1", 4));
  scene.models.push_back(box("puck", {0, -1, 0, 0}, {0.1, 0.1, 0.2}));
  scene.models.back().gripper_return = true;
  scene.models.back().fiducial_return = 3;
  scene.models.push_back(pioneer("f", {2, 1, 0, 2}));
  scene.models.back().position->velocity = {0.2, 0, 0, -0.3};
  scene::ModelDesc finder;
  finder.name = finder.alias = "f.fiducial:0";
  finder.kind = scene::ModelKind::kFiducial;
  finder.parent = 8;
  finder.alwayson = true;
  finder.fiducial.emplace();
  scene.models.push_back(finder);
  return scene;
}

constexpr std::uint32_t kRobot = 4, kPuck = 7, kFinder = 8;

/// What is done to the world before a tick. One of these happens in each tick of a run of 40.
void change(world::World& world, std::uint64_t tick) {
  switch (tick) {
    case 3:
      EXPECT_TRUE(world::spawn(world, kRobot, {1, -2, 0, 1}).ok());
      break;
    case 6:
      EXPECT_TRUE(world::attach(world, {kPuck}, {kRobot}, {0.4, 0, 0, 0}).ok());
      break;
    case 9:
      EXPECT_TRUE(world::spawn(world, kPuck, {0, 2, 0, 0}).ok());
      EXPECT_TRUE(world::spawn(world, kFinder, {-1, 2, 0, 0}).ok());
      break;
    case 14:
      EXPECT_TRUE(world::detach(world, {kPuck}).ok());
      break;
    case 18:
      EXPECT_TRUE(world::despawn(world, {kRobot}).ok());
      break;
    case 22:
      EXPECT_TRUE(world::set_pose(world, world.row({kPuck}), {2, 2, 0, 0}));
      break;
    case 25:  // a wall comes, and one goes
      EXPECT_TRUE(world::despawn(world, {0}).ok());
      EXPECT_TRUE(world::spawn(world, 1, {-3, 0, 0, 0}).ok());
      break;
    default:
      break;
  }
}

std::unique_ptr<world::Engine> engine_of(const scene::SceneDesc& scene, unsigned workers = 1) {
  Result<std::unique_ptr<world::Engine>> engine = make_engine(scene, {.seed = 5, .workers = workers});
  EXPECT_TRUE(engine.ok());
  return std::move(*engine);
}

using Changes = void(world::World& world, std::uint64_t tick);

void run(world::Engine& engine, std::uint64_t until, Changes& change) {
  while (engine.world().tick() < until) {
    change(engine.world(), engine.world().tick());
    engine.step();
  }
}

/// A run that is saved at any tick goes on as the one that ran through.
void expect_same_from_any_tick(const scene::SceneDesc& scene, std::uint64_t end, Changes& change) {
  const auto through = engine_of(scene);
  run(*through, end, change);
  for (std::uint64_t tick = 0; tick < end; ++tick) {
    const auto first = engine_of(scene);
    run(*first, tick, change);
    std::vector<std::byte> saved;
    ASSERT_TRUE(world::save_state(first->world(), saved).ok());
    const auto second = engine_of(scene, 1 + tick % 3);
    const Result<void> loaded = world::load_state(second->world(), saved);
    ASSERT_TRUE(loaded.ok()) << loaded.error().line();
    EXPECT_EQ(second->world().hash(), first->world().hash()) << tick;
    run(*second, end, change);
    EXPECT_EQ(second->world().hash(), through->world().hash()) << tick;
    EXPECT_EQ(second->world().sensed_hash(), through->world().sensed_hash()) << tick;
    EXPECT_EQ(world::first_difference(second->world(), through->world()), std::nullopt) << tick;
  }
}

TEST(ChangingPopulation, goes_on_from_any_tick_as_if_it_had_run_through) {
  expect_same_from_any_tick(make_scene(), 40, change);
}

/// Robots with a gripper each, which drive towards pucks (rows 4 to 6).
scene::SceneDesc grippers() {
  scene::SceneDesc scene;
  scene.name = "depot";
  for (const double y : {0.0, 1.0}) {
    const int robot = static_cast<int>(scene.models.size());
    const std::string name = "r" + std::to_string(robot);
    scene.models.push_back(testing::robot(name, {0, y, 0, 0}, {0.4, 0.4, 0.2}));
    scene.models.back().position->velocity = {0.1, 0, 0, 0.05};
    testing::add_gripper(scene, name + ".gripper:0", robot, {0.3, 0, 0, 0});
  }
  for (const double y : {0.02, 1.0, 2.0}) scene.models.push_back(testing::puck({0.4, y, 0, 0.4}));
  return scene;
}

/// Both close; one goes with what it holds, which another takes up; the other lifts, carries, opens, and
/// closes again.
void take_and_leave(world::World& world, std::uint64_t tick) {
  const auto tell = [&](ModelId gripper, world::GripperCommand command) {
    world::command_gripper(world, world.models.part[world.row(gripper)], command);
  };
  const auto holds = [&](ModelId gripper) {
    return static_cast<bool>(world::held_by(world, world.models.part[world.row(gripper)]));
  };
  constexpr ModelId kFirst{1}, kSecond{3}, kThird{8};
  switch (tick) {
    case 3:
      tell(kFirst, world::GripperCommand::kClose);
      tell(kSecond, world::GripperCommand::kClose);
      break;
    case 8:
      tell(kSecond, world::GripperCommand::kRaise);
      break;
    case 24:
      EXPECT_TRUE(holds(kFirst) && holds(kSecond));
      tell(kSecond, world::GripperCommand::kOpen);
      tell(kSecond, world::GripperCommand::kLower);
      break;
    case 26: {
      const geom::Pose at = world.models.X_WM[{0}];
      EXPECT_TRUE(world::despawn(world, {0}).ok());
      EXPECT_TRUE(world::spawn(world, 0, at).ok());
      tell(kThird, world::GripperCommand::kClose);
      break;
    }
    case 30:
      EXPECT_FALSE(holds(kSecond));
      EXPECT_GT(world.models.X_WM[world.row({5})].x, 0.5) << "carried and put down";
      tell(kSecond, world::GripperCommand::kClose);
      break;
    case 52:
      EXPECT_TRUE(holds(kThird));
      world::return_to_start(world);
      break;
    default:
      break;
  }
}

TEST(ChangingPopulation, goes_on_from_any_tick_with_full_grippers_of_robots_that_come_and_go) {
  expect_same_from_any_tick(grippers(), 56, take_and_leave);
}

TEST(ChangingPopulation, robots_see_who_came_and_no_longer_who_went) {
  const scene::SceneDesc scene = make_scene();
  const auto engine = engine_of(scene);
  world::World& world = engine->world();
  world::command_velocity(world, world.position({kRobot}), {});
  engine->step();
  const auto ahead = [&] {
    const world::RangerRow laser = world.models.part[world.row({kRobot + 2})];
    return world.sensors.ranges[world.sensors.first_beam[world.rangers.first_sensor[laser]] + 90];
  };
  const float free = ahead();
  const geom::Pose at = world.models.X_WM[{kRobot}];
  const geom::Pose before = geom::compose(at, {1.5, 0, 0, 0});
  const Result<ModelId> other = world::spawn(world, kFinder, before);
  ASSERT_TRUE(other.ok());
  engine->step();
  EXPECT_NEAR(ahead(), 1.5 - 0.26, 0.1);
  ASSERT_TRUE(world::despawn(world, *other).ok());
  engine->step();
  EXPECT_NEAR(ahead(), free, 0.1);
}

TEST(ChangingPopulation, a_robot_that_came_is_in_the_way_and_what_it_carries_as_well) {
  const scene::SceneDesc scene = make_scene();
  const auto engine = engine_of(scene);
  world::World& world = engine->world();
  const Result<ModelId> blocker = world::spawn(world, kFinder, {-1, 0, 0, 0});
  ASSERT_TRUE(blocker.ok());
  world::command_velocity(world, world.position(*blocker), {});
  world::command_velocity(world, world.position({kRobot}), {0.5, 0, 0, 0});
  for (int i = 0; i < 30; ++i) engine->step();
  EXPECT_EQ(world.positions.stall[world.position({kRobot})], 1);
  const double x = world.models.X_WM[{kRobot}].x;
  EXPECT_LT(x, -1.4);
  ASSERT_TRUE(world::despawn(world, *blocker).ok());
  for (int i = 0; i < 5; ++i) engine->step();
  EXPECT_GT(world.models.X_WM[{kRobot}].x, x + 0.1);
}

TEST(ChangingPopulation, what_holds_something_loose_leaves_no_wall_behind_where_it_stood) {
  scene::SceneDesc scene;
  scene.models.push_back(pioneer("r", {0, 0, 0, 0}));
  scene.models.push_back(laser("r.ranger:0", 0));
  scene.models.push_back(box("table", {2, 0, 0, 0}, {0.2, 0.2, 1}));
  scene.models.push_back(box("cup", {0, 5, 0, 0}, {0.1, 0.1, 0.1}));
  scene.models.back().gripper_return = true;
  const auto engine = engine_of(scene);
  world::World& world = engine->world();
  const auto ahead = [&] { return (engine->step(), world.sensors.ranges[{90}]); };
  EXPECT_LT(ahead(), 2);
  ASSERT_TRUE(world::attach(world, {3}, {2}, {0, 0, 1, 0}).ok());
  EXPECT_LT(ahead(), 2);
  ASSERT_TRUE(world::set_pose(world, {2}, {5, 5, 0, 0}));
  EXPECT_EQ(ahead(), 8);
  ASSERT_TRUE(world::set_pose(world, {2}, {2, 0, 0, 0}));
  ASSERT_TRUE(world::detach(world, {3}).ok());
  EXPECT_LT(ahead(), 2);
  ASSERT_TRUE(world::set_pose(world, {2}, {5, 5, 0, 0}));
  EXPECT_EQ(ahead(), 8);
}

// Rows of later models change as one goes.
TEST(Population, walls_stay_where_they_are_as_models_before_them_go) {
  scene::SceneDesc scene;
  scene.models.push_back(box("puck", {0, 3, 0, 0}, {0.3, 0.3, 0.3}));
  scene.models.back().gripper_return = true;
  scene.models.push_back(box("wall", {3, 0, 0, 0}, {1, 1, 1}));
  scene.models.push_back(pioneer("r", {0, 0, 0, 0}));
  scene.models.back().position->velocity = {1, 0, 0, 0};
  scene.models.push_back(laser("r.ranger:0", 2));
  auto engine = make_engine(scene, {.seed = 1, .workers = 1});
  ASSERT_TRUE(engine.ok());
  world::World& world = (*engine)->world();
  (*engine)->step();
  ASSERT_TRUE(world::despawn(world, world.id({0})).ok());
  for (int tick = 0; tick < 100; ++tick) (*engine)->step();
  const world::ModelRow robot = world.find("r");
  EXPECT_NEAR(world.models.X_WM[robot].x, 2.3, 0.15) << "it stops at the wall";
  const RowsOf beams = world.sensors.ranges.rows();
  EXPECT_LT(world.sensors.ranges[beams[beams.size() / 2]], 0.5f) << "and sees it";
}

}  // namespace
}  // namespace playhouse::stage
