// How actuators move themselves and what they carry, what is in their way, and what stands still with them.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "playhouse/bodies/overlap.h"
#include "playhouse/stage/engine.h"
#include "playhouse/stage/testing_scenes.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::stage {
namespace {

using scene::ActuatorType;
using testing::actuator;
using testing::box;
using testing::robot;
using world::Mobility;
using world::World;

/// A scene that runs; rows of models are those of the scene.
class Running {
 public:
  explicit Running(scene::SceneDesc scene, unsigned workers = 1) : scene_(std::move(scene)) {
    auto made = make_engine(scene_, {.seed = 3, .workers = workers});
    EXPECT_TRUE(made.ok()) << (made ? "" : made.error().line());
    engine_ = std::move(*made);
  }
  World& world() { return engine_->world(); }
  const geom::Pose& X_WM(world::ModelRow row) { return world().models.X_WM[row]; }
  double position(world::ActuatorRow actuator = {0}) { return world().actuators.position[actuator]; }
  bool stalls(world::ActuatorRow actuator = {0}) { return world().actuators.stall[actuator] != 0; }
  void step(int ticks = 1) {
    for (int k = 0; k < ticks; ++k) engine_->step();
  }
  void set_speed(double speed, std::uint32_t actuator = 0) {
    EXPECT_TRUE(world::command_joint_velocity(world(), world::ActuatorRow{actuator}, speed));
  }

 private:
  scene::SceneDesc scene_;
  std::unique_ptr<world::Engine> engine_;
};

/// A slide at (1, 2) that looks along y and goes ahead, with a puck's post on its far end.
scene::SceneDesc slide() {
  scene::SceneDesc scene;
  scene.models.push_back(actuator("slide", {1, 2, 0, geom::kPi / 2}, {0.2, 0.2, 0.2}));
  scene.models.push_back(box("load", {0.1, 0, 0.2, 0}, {0.1, 0.1, 0.1}));
  scene.models.back().parent = 0;
  return scene;
}

TEST(Actuator, slides_along_its_own_axis_with_what_it_carries) {
  Running run(slide());
  run.set_speed(0.5);
  run.step(6);
  EXPECT_NEAR(run.position(), 0.3, 1e-12);
  EXPECT_NEAR(run.X_WM({0}).x, 1, 1e-12);
  EXPECT_NEAR(run.X_WM({0}).y, 2.3, 1e-12);
  EXPECT_NEAR(run.X_WM({1}).y, 2.4, 1e-12);
  EXPECT_EQ(run.world().models.X_PM[{1}], (geom::Pose{0.1, 0, 0.2, 0}));
}

TEST(Actuator, turns_what_it_carries_about_itself) {
  scene::SceneDesc scene = slide();
  scene.models[0].actuator->type = ActuatorType::kRotational;
  scene.models[0].actuator->axis_z = -2;
  Running run(scene);
  run.set_speed(0.5);
  run.step(10);
  EXPECT_NEAR(run.position(), 0.5, 1e-12);
  EXPECT_NEAR(run.X_WM({0}).a, geom::kPi / 2 - 0.5, 1e-12) << "its axis points down";
  EXPECT_NEAR(run.X_WM({1}).x, 1 + 0.1 * std::sin(0.5), 1e-12);
  EXPECT_NEAR(run.X_WM({1}).y, 2 + 0.1 * std::cos(0.5), 1e-12);
}

TEST(Actuator, moves_while_somebody_has_it_open_only) {
  scene::SceneDesc scene = slide();
  scene.models[0].alwayson = false;
  Running run(scene);
  run.set_speed(0.5);
  run.step(3);
  EXPECT_EQ(run.position(), 0);
  world::subscribe(run.world(), {0});
  run.step(3);
  EXPECT_NEAR(run.position(), 0.15, 1e-12);
  world::unsubscribe(run.world(), {0});
  run.step(3);
  EXPECT_NEAR(run.position(), 0.15, 1e-12);
  world::subscribe(run.world(), {0});
  run.step(3);
  EXPECT_NEAR(run.position(), 0.15, 1e-12) << "a command ends with the last who has it open";
}

TEST(Actuator, stops_at_its_ends) {
  scene::SceneDesc scene = slide();
  scene.models[0].actuator->min_position = -0.13;
  scene.models[0].actuator->max_position = 0.27;
  Running run(scene);
  run.set_speed(100);
  run.step();
  EXPECT_NEAR(run.position(), 0.1, 1e-12) << "at most 1 m/s";
  run.step(5);
  EXPECT_EQ(run.position(), 0.27);
  EXPECT_EQ(run.world().actuators.velocity[{0}], 0);
  EXPECT_FALSE(run.stalls());
  EXPECT_NEAR(run.X_WM({0}).y, 2.27, 1e-12);
  run.set_speed(-0.7);
  run.step(20);
  EXPECT_EQ(run.position(), -0.13);
}

TEST(Actuator, starts_where_the_file_says_counted_from_its_pose) {
  scene::SceneDesc scene = slide();
  scene.models[0].actuator->start_position = 0.4;
  Running run(scene);
  EXPECT_EQ(run.position(), 0.4);
  EXPECT_NEAR(run.X_WM({0}).y, 2.4, 1e-12);
  EXPECT_NEAR(run.X_WM({1}).y, 2.5, 1e-12);
  run.set_speed(-1);
  run.step(10);
  EXPECT_NEAR(run.position(), 0, 1e-12);
  EXPECT_NEAR(run.X_WM({0}).y, 2, 1e-12);
  world::return_to_start(run.world());
  run.step();
  EXPECT_EQ(run.position(), 0.4);
  EXPECT_NEAR(run.X_WM({1}).y, 2.5, 1e-12);
}

TEST(Actuator, that_is_put_elsewhere_goes_on_from_there) {
  Running run(slide());
  run.set_speed(0.5);
  run.step(2);
  EXPECT_TRUE(world::set_pose(run.world(), {0}, {-3, -3, 0, 0}));
  run.step(2);
  EXPECT_NEAR(run.position(), 0.2, 1e-12);
  EXPECT_NEAR(run.X_WM({0}).x, -2.9, 1e-12);
  EXPECT_NEAR(run.X_WM({0}).y, -3, 1e-12);
}

TEST(Actuator, stalls_before_a_wall_and_goes_on_when_it_is_free) {
  scene::SceneDesc scene = slide();
  scene.models.push_back(box("wall", {1, 2.5, 0, 0}, {2, 0.1, 1}));
  Running run(scene);
  run.set_speed(0.45);
  run.step(20);
  EXPECT_TRUE(run.stalls());
  EXPECT_NEAR(run.position(), 0.27, 1e-12) << "the load ends 0.15 m ahead of it, the wall begins at 2.45 m";
  EXPECT_NEAR(run.X_WM({1}).y, 2.37, 1e-12);
  run.set_speed(-0.45);
  run.step();
  EXPECT_FALSE(run.stalls());
  EXPECT_NEAR(run.position(), 0.225, 1e-12);
}

TEST(Actuator, is_in_the_way_of_robots_and_they_in_its) {
  scene::SceneDesc scene = slide();
  scene.models.push_back(robot("r", {1, 2.6, 0, -geom::kPi / 2}, {0.3, 0.3, 0.5}));
  scene.models.back().position->velocity = {0.2, 0, 0, 0};
  Running run(scene);
  run.step(30);
  EXPECT_EQ(run.world().positions.stall[{0}], 1);
  EXPECT_NEAR(run.X_WM({2}).y, 2.3, 0.021) << "the load ends at 2.15 m";
  run.set_speed(0.4);
  run.step(5);
  EXPECT_TRUE(run.stalls());
  EXPECT_TRUE(world::command_velocity(run.world(), {0}, {-0.5, 0, 0, 0}));
  run.step(5);
  EXPECT_FALSE(run.stalls());
  EXPECT_EQ(run.world().positions.stall[{0}], 0);
}

/// A gate across y = 0 that can rise, and a robot before it.
scene::SceneDesc gate() {
  scene::SceneDesc scene;
  scene.models.push_back(actuator("gate", {1, 0, 0, 0}, {0.1, 2, 1}));
  scene.models.back().actuator->axis_z = 1;
  scene.models.back().actuator->max_position = 2;
  scene.models.push_back(robot("r", {0, 0, 0, 0}, {0.4, 0.4, 0.5}));
  scene.models.back().position->velocity = {0.5, 0, 0, 0};
  scene.models.push_back(testing::ranger("eye", 1, {0, 0, 0.2, 0}));
  scene.models.back().sensors.push_back(testing::sensor({}, 5, 0, 1));
  return scene;
}

TEST(Actuator, that_rises_lets_robots_and_beams_through_beneath) {
  Running run(gate());
  run.step(20);
  EXPECT_EQ(run.world().positions.stall[{0}], 1);
  EXPECT_NEAR(run.X_WM({1}).x, 0.75, 1e-6);
  EXPECT_NEAR(run.world().sensors.ranges[{0}], 0.2, 1e-6);
  run.set_speed(0.8);
  run.step(6);
  EXPECT_NEAR(run.X_WM({0}).z, 0.48, 1e-12);
  EXPECT_EQ(run.world().positions.stall[{0}], 1) << "the robot is 0.5 m high";
  EXPECT_NEAR(run.world().sensors.ranges[{0}], 5, 1e-6) << "its eye is at 0.2 m";
  run.step(20);
  EXPECT_GT(run.X_WM({1}).x, 1.5);
  run.set_speed(-0.8);
  run.step(40);
  EXPECT_EQ(run.position(), 0);
}

TEST(Actuator, does_not_come_down_on_what_is_beneath) {
  scene::SceneDesc scene = gate();
  scene.models[0].actuator->start_position = 1;
  scene.models[1].X_PM.x = 1;
  scene.models[1].position->velocity = {};
  Running run(scene);
  run.set_speed(-0.3);
  run.step(20);
  EXPECT_TRUE(run.stalls());
  EXPECT_NEAR(run.X_WM({0}).z, 0.52, 0.021);
  EXPECT_GE(run.X_WM({0}).z, 0.5);
  EXPECT_TRUE(world::command_velocity(run.world(), {0}, {0.5, 0, 0, 0}));
  run.step(20);
  EXPECT_EQ(run.world().positions.stall[{0}], 0);
  EXPECT_LT(run.X_WM({0}).z, 0.4);
}

TEST(Actuator, over_or_under_a_block_that_is_wider_does_not_go_into_it) {
  scene::SceneDesc scene;
  scene.models.push_back(actuator("lift", {0, 0, 0.8, 0}, {0.2, 0.2, 0.2}));
  scene.models.back().actuator->axis_z = 1;
  scene.models.back().actuator->min_position = -1;
  scene.models.push_back(box("table", {0, 0, 0, 0}, {5, 5, 0.5}));
  scene.models.push_back(box("ceiling", {0, 0, 1.5, 0}, {5, 5, 0.1}));
  Running run(scene);
  run.set_speed(-0.4);
  run.step(20);
  EXPECT_TRUE(run.stalls());
  EXPECT_NEAR(run.X_WM({0}).z, 0.52, 1e-12);
  run.set_speed(0.4);
  run.step(40);
  EXPECT_TRUE(run.stalls());
  EXPECT_NEAR(run.X_WM({0}).z, 1.28, 1e-12);
}

TEST(Actuator, does_not_jump_what_is_thinner_than_its_way_in_a_tick) {
  scene::SceneDesc scene = gate();
  scene.models[0].actuator->max_speed = 50;
  scene.models[0].actuator->max_position = 10;
  scene.models.push_back(box("beam", {1, 0, 1.5, 0}, {1, 0.02, 0.02}));
  Running run(scene);
  run.set_speed(50);
  run.step();
  EXPECT_TRUE(run.stalls());
  EXPECT_EQ(run.position(), 0);
  scene = slide();
  scene.models[0].actuator->max_speed = 100;
  scene.models[0].actuator->max_position = 100;
  scene.models[0].actuator->type = ActuatorType::kRotational;
  scene.models[1].X_PM.x = 1;
  scene.models.push_back(box("post", {1, 1, 0, 0}, {0.01, 0.01, 1}));
  Running turning(scene);
  turning.set_speed(62.8);  // almost a whole turn in a tick
  turning.step();
  EXPECT_TRUE(turning.stalls());
}

/// Four walls as one contour, with a door as a part of them, and a robot within.
scene::SceneDesc house() {
  scene::SceneDesc scene;
  scene::ModelDesc& walls = scene.models.emplace_back();
  walls.name = walls.alias = "walls";
  walls.bitmaps.push_back({{{{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}}, 0, 1});
  scene.models.push_back(actuator("door", {3, 0, 0, geom::kPi / 2}, {1, 0.1, 1}));
  scene.models.back().parent = 0;
  scene.models.push_back(robot("r", {0, 0, 0, 0}, {0.4, 0.4, 0.5}));
  scene.models.back().position->velocity = {0.5, 0, 0, 0};
  return scene;
}

TEST(Actuator, on_walls_leaves_them_walls) {
  Running run(house());
  EXPECT_EQ(run.world().models.mobility[{0}], Mobility::kFixed);
  EXPECT_EQ(run.world().models.mobility[{1}], Mobility::kDriven);
  run.set_speed(0.5);
  run.step(10);
  EXPECT_NEAR(run.X_WM({2}).x, 0.5, 1e-12) << "who is between walls is not in them";
  EXPECT_NEAR(run.X_WM({1}).y, 0.5, 1e-12) << "and they are not in the way of their own door";
  run.step(60);
  EXPECT_EQ(run.world().positions.stall[{0}], 1);
  EXPECT_TRUE(world::set_pose(run.world(), {0}, {5, 0, 0, 0}));
  run.step(20);
  EXPECT_EQ(run.world().positions.stall[{0}], 0) << "the walls are elsewhere, with their door";
  EXPECT_NEAR(run.X_WM({1}).x, 8, 1e-12);
}

TEST(Actuator, at_the_top_or_on_a_robot_is_driven_with_all_that_it_carries) {
  scene::SceneDesc scene = slide();
  scene.models.push_back(robot("r", {5, 0, 0, 0}, {0.4, 0.4, 0.2}));
  scene.models.push_back(actuator("arm", {0.2, 0, 0.2, 0}, {0.1, 0.1, 0.1}));
  scene.models.back().parent = 2;
  Running run(scene);
  for (std::uint32_t row = 0; row < 4; ++row)
    EXPECT_EQ(run.world().models.mobility[{row}], Mobility::kDriven) << row;
}

TEST(Actuator, on_a_robot_moves_with_it) {
  scene::SceneDesc scene;
  scene.models.push_back(robot("r", {0, 0, 0, 0}, {0.4, 0.4, 0.2}));
  scene.models.back().position->velocity = {0.5, 0, 0, 0.5};
  scene.models.push_back(actuator("arm", {0.2, 0, 0.2, 0}, {0.1, 0.1, 0.1}));
  scene.models.back().parent = 0;
  scene.models.push_back(testing::ranger("eye", 1, {0.1, 0, 0.1, 0}));
  scene.models.back().sensors.push_back(testing::sensor({}, 5, 0, 1));
  scene.models.push_back(box("wall", {3, 0, 0, 0}, {0.2, 20, 1}));
  Running run(scene);
  run.set_speed(0.2);
  run.step(10);
  const geom::Pose X_WE = geom::compose(run.X_WM({0}), {0.2 + 0.2 + 0.1, 0, 0.3, 0});
  EXPECT_NEAR(run.X_WM({2}).x, X_WE.x, 1e-12);
  EXPECT_NEAR(run.X_WM({2}).y, X_WE.y, 1e-12);
  EXPECT_NEAR(run.world().sensors.ranges[{0}], (2.9 - X_WE.x) / std::cos(X_WE.a), 1e-6);
  EXPECT_EQ(run.world().positions.X_OM[{0}], run.X_WM({0})) << "wheels know nothing of the arm";
}

/// Slides, arms on robots, and lifts, each at its own speed, close to each other.
scene::SceneDesc workshop(std::size_t machines, std::uint64_t seed) {
  scene::SceneDesc scene = testing::throng(machines, seed);
  const std::size_t first = 4;  // behind the walls
  std::vector<scene::ModelDesc> models(scene.models.begin(), scene.models.begin() + first);
  for (std::size_t i = first; i < scene.models.size(); ++i) {
    Rng rng(seed, 1, {Purpose::kTestScene, static_cast<std::uint32_t>(i)});
    const int parent = static_cast<int>(models.size());
    models.push_back(scene.models[i]);
    const std::size_t kind = i % 3;
    if (kind == 1) {
      scene::ModelDesc lift = actuator(models.back().name, models.back().X_PM, models.back().size);
      lift.actuator->axis_z = 1;
      lift.actuator->min_position = -1;
      models.back() = lift;
    }
    if (kind == 0) continue;
    models.push_back(
        actuator(models.back().name + ".arm", {0.05, 0, 0.05, rng.uniform(-3, 3)}, {0.15, 0.05, 0.1}));
    models.back().parent = parent;
    models.back().X_MB = {0.05, 0, 0, 0};
    if (rng.uniform() < 0.5) models.back().actuator->type = ActuatorType::kRotational;
    models.back().actuator->min_position = -1;
  }
  scene.models = std::move(models);
  return scene;
}

void command_all(World& world, std::uint64_t seed) {
  for (const world::ActuatorRow row : world.actuators.rows()) {
    Rng rng(seed, world.tick(), {Purpose::kTestScene, row.index});
    const double number = rng.uniform(-1, 1);
    if (row.index % 2 == 0) {
      EXPECT_TRUE(world::command_joint_velocity(world, row, number));
    } else {
      EXPECT_TRUE(world::command_joint_position(world, row, number));
    }
  }
}

void run_workshop(Running& run, std::uint64_t until) {
  while (run.world().tick() < until) {
    if (run.world().tick() % 7 == 0) command_all(run.world(), 9);
    run.step();
  }
}

/// Whether bodies of two trees overlap, and at the same height.
bool any_overlap(const World& world) {
  struct Body {
    std::vector<geom::Vec2> p;
    geom::Vec2 center;
    double z_min, z_max;
    world::ModelRow root;
    bool fixed;  // walls may overlap each other
  };
  std::vector<Body> bodies;
  for (const world::ModelRow row : world.models.rows()) {
    const scene::ModelDesc& desc = world.desc(row);
    const geom::Pose X_WB = geom::compose(world.models.X_WM[row], desc.X_MB);
    Body body{{},
              X_WB.xy(),
              X_WB.z,
              X_WB.z + desc.size.z,
              world.models.root[row],
              world.models.mobility[row] == Mobility::kFixed};
    for (const geom::Vec2 p : desc.blocks[0].points) body.p.push_back(geom::transform(X_WB, p));
    for (const Body& other : bodies) {
      const bool high =
          body.z_min < other.z_max - 2 * bodies::kTouch && other.z_min < body.z_max - 2 * bodies::kTouch;
      if (high && other.root != body.root && !(other.fixed && body.fixed) &&
          bodies::overlap({body.p, body.center, true}, {other.p, other.center, true}))
        return true;
    }
    bodies.push_back(std::move(body));
  }
  return false;
}

RC_GTEST_PROP(Actuators, and_what_they_carry_that_start_apart_never_come_to_overlap_another_tree, ()) {
  const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1 << 20);
  Running run(workshop(static_cast<std::size_t>(*rc::gen::inRange(2, 20)), seed));
  RC_PRE(!any_overlap(run.world()));
  for (int tick = 0; tick < 40; ++tick) {
    if (tick % 5 == 0) command_all(run.world(), seed);
    run.step();
    RC_ASSERT(!any_overlap(run.world()));
  }
}

TEST(Actuators, move_the_same_for_any_number_of_workers) {
  const auto hashes = [](unsigned workers) {
    Running run(workshop(300, 1), workers);
    run_workshop(run, 60);
    return std::pair(run.world().hash(), run.world().sensed_hash());
  };
  EXPECT_EQ(hashes(1), hashes(3));
}

TEST(Actuators, go_on_from_any_tick_as_if_they_had_run_through) {
  constexpr std::uint64_t kEnd = 30;
  Running through(workshop(40, 2));
  run_workshop(through, kEnd);
  std::size_t stalls = 0;
  for (const std::uint8_t stall : through.world().actuators.stall) stalls += stall;
  EXPECT_GT(stalls, 0u);
  for (std::uint64_t tick = 0; tick < kEnd; ++tick) {
    Running first(workshop(40, 2)), second(workshop(40, 2), 1 + tick % 3);
    run_workshop(first, tick);
    std::vector<std::byte> saved;
    ASSERT_TRUE(world::save_state(first.world(), saved).ok());
    const Result<void> loaded = world::load_state(second.world(), saved);
    ASSERT_TRUE(loaded.ok()) << loaded.error().line();
    run_workshop(second, kEnd);
    EXPECT_EQ(second.world().hash(), through.world().hash()) << tick;
    EXPECT_EQ(world::first_difference(second.world(), through.world()), std::nullopt) << tick;
  }
}

TEST(Actuators, whose_way_makes_no_sense_are_refused) {
  const auto is_refused = [](double lower, double upper, double start, double speed) {
    scene::SceneDesc scene = slide();
    scene::ActuatorDesc& desc = *scene.models[0].actuator;
    desc.min_position = lower;
    desc.max_position = upper;
    desc.start_position = start;
    desc.max_speed = speed;
    return !make_engine(scene, {}).ok();
  };
  EXPECT_FALSE(is_refused(-1, 1, 0, 1));
  EXPECT_TRUE(is_refused(0, -1, 0, 1));
  EXPECT_TRUE(is_refused(0, 1, 2, 1));
  EXPECT_TRUE(is_refused(0, 1e300, 0, 1));
  EXPECT_TRUE(is_refused(0, 1, std::nan(""), 1));
  EXPECT_TRUE(is_refused(0, 1, 0, -1));
}

}  // namespace
}  // namespace playhouse::stage
