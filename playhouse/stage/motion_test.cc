#include "playhouse/stage/motion.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <optional>

#include "playhouse/stage/engine.h"
#include "playhouse/stage/testing_scenes.h"

namespace playhouse::stage {
namespace {

using testing::box;
using testing::robot;

std::unique_ptr<world::Engine> engine_of(const scene::SceneDesc& scene, unsigned workers = 1) {
  auto made = make_engine(scene, {.seed = 7, .workers = workers});
  PLAYHOUSE_ASSERT(made.ok());
  return std::move(*made);
}

/// The corners of a model's block after it has driven at `v` for `dt`.
std::vector<geom::Vec2> corners(const world::World& world, world::ModelRow row, const geom::Twist& v = {},
                                double dt = 0) {
  const scene::ModelDesc& desc = world.desc(row);
  const geom::Pose X_WM = geom::compose(world.models.X_WM[{row}], {v.x * dt, v.y * dt, 0, v.a * dt});
  const geom::Pose X_WB = geom::compose(X_WM, desc.X_MB);
  std::vector<geom::Vec2> points;
  for (const geom::Vec2 p : desc.blocks[0].points) points.push_back(geom::transform(X_WB, p));
  return points;
}

/// The oracle: how deep two convex polygons overlap, by their best separating axis. Negative: apart.
double depth(const std::vector<geom::Vec2>& first, const std::vector<geom::Vec2>& second) {
  double best = 1e300;
  for (const auto* polygon : {&first, &second}) {
    for (std::size_t i = 0; i < polygon->size(); ++i) {
      const geom::Vec2 e = (*polygon)[(i + 1) % polygon->size()] - (*polygon)[i];
      const double length = std::sqrt(geom::dot(e, e));
      double a_min = 1e300, a_max = -1e300, b_min = 1e300, b_max = -1e300;
      for (const geom::Vec2 p : first) {
        a_min = std::min(a_min, geom::cross(e, p) / length);
        a_max = std::max(a_max, geom::cross(e, p) / length);
      }
      for (const geom::Vec2 p : second) {
        b_min = std::min(b_min, geom::cross(e, p) / length);
        b_max = std::max(b_max, geom::cross(e, p) / length);
      }
      best = std::min(best, std::min(a_max - b_min, b_max - a_min));
    }
  }
  return best;
}

double in(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1 << 20) / (1 << 20);
}

scene::SceneDesc any_crowd(double speed) {
  scene::SceneDesc scene =
      testing::crowd(static_cast<std::size_t>(*rc::gen::inRange(2, 40)), testing::Sensing::kNone);
  for (scene::ModelDesc& model : scene.models) {
    if (!model.position) continue;
    model.position->velocity = {in(-speed, speed), 0, 0, in(-1.5, 1.5)};
    model.position->velocity_bounds[0] = {-speed, speed};
  }
  return scene;
}

double deepest(const world::World& world) {
  double deepest = -1;
  for (const world::ModelRow a : world.models.rows())
    for (const world::ModelRow b : RowsOf(world.models.rows().front(), a))
      if (world.desc(a).position || world.desc(b).position)
        deepest = std::max(deepest, depth(corners(world, a), corners(world, b)));
  return deepest;
}

RC_GTEST_PROP(Motion, bodies_that_start_apart_never_come_to_overlap, ()) {
  const scene::SceneDesc scene = any_crowd(*rc::gen::element(0.5, 3.0, 12.0));
  const auto engine = engine_of(scene);
  RC_PRE(deepest(engine->world()) <= 0);
  for (int tick = 0; tick < 30; ++tick) {
    engine->step();
    RC_ASSERT(deepest(engine->world()) < 2 * bodies::kTouch);
  }
}

/// The oracle: who stalls in the next tick if models move one after the other, in row order, each to its end
/// of the tick if nothing is there by then. Nothing if one of them is too close to call.
std::optional<std::vector<bool>> stalls_one_after_the_other(const world::World& world) {
  world::ByModel<std::vector<geom::Vec2>> place;
  for (const world::ModelRow row : world.models.rows()) place.push_back(corners(world, row));
  std::vector<bool> stalls;
  for (const world::ModelRow row : world.models.rows()) {
    if (!world.desc(row).position) continue;
    const auto then = corners(world, row, world.positions.command[world.models.part[row]], 0.1);
    double met = -1;
    for (const world::ModelRow other : world.models.rows())
      if (other != row) met = std::max(met, depth(then, place[other]));
    if (met > -1e-5 && met < 1e-4) return std::nullopt;
    stalls.push_back(met > 0);
    if (met < 0) place[row] = then;
  }
  return stalls;
}

RC_GTEST_PROP(Motion, a_tick_is_that_of_robots_moving_one_after_the_other, ()) {
  const auto robots = static_cast<std::size_t>(*rc::gen::inRange(2, 60));
  const scene::SceneDesc scene = testing::throng(robots, *rc::gen::inRange<std::uint64_t>(0, 1 << 20));
  const auto engine = engine_of(scene);
  const world::World& world = engine->world();
  for (int tick = 0; tick < 40; ++tick) {
    const auto expected = stalls_one_after_the_other(world);
    if (!expected) break;
    engine->step();
    const std::vector<bool> stalls(world.positions.stall.begin(), world.positions.stall.end());
    RC_ASSERT(stalls == *expected);
  }
}

TEST(Motion, a_robot_that_is_a_part_of_walls_leaves_them_where_they_are_for_all_others) {
  scene::SceneDesc scene;
  scene.models.push_back(testing::box("walls", {2, 0, 0, 0}, {0.2, 4, 1}));
  scene.models.push_back(testing::robot("inside", {-1, 1, 0, 0}, {0.3, 0.3, 0.3}));
  scene.models.back().parent = 0;
  scene.models.push_back(testing::robot("outside", {1, 0, 0, 0}, {0.3, 0.3, 0.3}));
  for (scene::ModelDesc& model : scene.models)
    if (model.position) model.position->velocity = {0.5, 0, 0, 0};
  const auto engine = engine_of(scene);
  for (int tick = 0; tick < 40; ++tick) engine->step();
  const world::World& world = engine->world();
  EXPECT_EQ(world.models.X_WM[{0}], (geom::Pose{2, 0, 0, 0}));
  EXPECT_NEAR(world.models.X_WM[{1}].x, 3, 1e-12) << "what is of its own tree is not in its way";
  EXPECT_EQ(world.positions.stall[{1}], 1);
  ASSERT_TRUE(world::set_pose(engine->world(), {0}, {5, 0, 0, 0}));
  for (int tick = 0; tick < 10; ++tick) engine->step();
  EXPECT_EQ(world.positions.stall[{1}], 0) << "the walls went, with the robot in them";
  EXPECT_NEAR(world.models.X_WM[{1}].x, 6.5, 1e-12);
}

TEST(Motion, a_throng_gives_the_same_bits_with_any_number_of_workers) {
  const scene::SceneDesc scene = testing::throng(300, 1);
  std::vector<std::uint64_t> hashes;
  for (const unsigned workers : {1u, 2u, 4u}) {
    const auto engine = engine_of(scene, workers);
    for (int tick = 0; tick < 60; ++tick) engine->step();
    hashes.push_back(engine->world().hash());
  }
  EXPECT_EQ(hashes, std::vector<std::uint64_t>(3, hashes[0]));
}

/// Boxes 0.2 m long that drive along x at these places and speeds, in this order of rows.
struct Driver {
  double x, speed;
};
scene::SceneDesc file_of(const std::vector<Driver>& drivers) {
  scene::SceneDesc scene;
  for (const auto& [x, speed] : drivers) {
    scene.models.push_back(robot("r" + std::to_string(scene.models.size()), {x, 0, 0, 0}, {0.2, 0.2, 0.2}));
    scene.models.back().position->velocity = {speed, 0, 0, 0};
  }
  return scene;
}

TEST(Motion, a_robot_that_another_one_drives_into_from_behind_goes_on) {
  const Driver front{0.25, 0.3}, rear{0, 1};
  for (const bool rear_first : {true, false}) {
    const scene::SceneDesc scene = file_of(rear_first ? std::vector{rear, front} : std::vector{front, rear});
    const auto engine = engine_of(scene);
    const world::World& world = engine->world();
    const std::uint32_t at_front = rear_first ? 1 : 0, at_rear = 1 - at_front;
    int waits = 0;
    for (int tick = 1; tick <= 30; ++tick) {
      engine->step();
      EXPECT_EQ(world.positions.stall[{at_front}], 0) << "tick " << tick;
      EXPECT_NEAR(world.models.X_WM[{at_front}].x, 0.25 + 0.03 * tick, 1e-9);
      waits += world.positions.stall[{at_rear}];
    }
    EXPECT_GT(waits, 0);
    EXPECT_GT(world.models.X_WM[{at_rear}].x, world.models.X_WM[{at_front}].x - 0.35) << "follows";
  }
}

TEST(Motion, a_convoy_bumper_to_bumper_drives_in_either_order_of_the_file) {
  constexpr int kLength = 8, kTicks = 20;
  std::vector<Driver> convoy;
  for (int k = 0; k < kLength; ++k) convoy.push_back({-0.2 * k, 0.5});
  const scene::SceneDesc forwards = file_of(convoy), backwards = file_of({convoy.rbegin(), convoy.rend()});
  const auto front_first = engine_of(forwards), rear_first = engine_of(backwards);
  for (int tick = 0; tick < kTicks; ++tick) {
    front_first->step();
    rear_first->step();
  }
  for (std::uint32_t k = 0; k < kLength; ++k) {
    EXPECT_NEAR(front_first->world().models.X_WM[{k}].x, -0.2 * k + 0.05 * kTicks, 1e-9);
    // Each sets off when the one before it has left: one tick later.
    EXPECT_NEAR(rear_first->world().models.X_WM[{kLength - 1 - k}].x, -0.2 * k + 0.05 * (kTicks - k), 1e-9);
  }
}

TEST(Motion, of_two_that_meet_head_on_the_first_in_the_file_takes_the_room_and_both_stop) {
  const scene::SceneDesc scene = file_of({{0.27, -0.5}, {0, 0.5}});  // 0.07 m apart
  const auto engine = engine_of(scene);
  const world::World& world = engine->world();
  for (int tick = 0; tick < 10; ++tick) engine->step();
  EXPECT_NEAR(world.models.X_WM[{0}].x, 0.22, 1e-9);
  EXPECT_EQ(world.models.X_WM[{1}].x, 0);
  EXPECT_EQ(world.positions.stall[{0}], 1);
  EXPECT_EQ(world.positions.stall[{1}], 1);
}

TEST(Motion, a_chain_of_refused_moves_stops_nobody_else) {
  scene::SceneDesc scene;
  scene.models.push_back(box("wall", {0.18, 0, 0, 0}, {0.1, 2, 1}));  // 0.03 m before the first of the queue
  for (int k = 0; k < 3; ++k) {
    scene.models.push_back(robot("r" + std::to_string(k), {-0.23 * k, 0, 0, 0}, {0.2, 0.2, 0.2}));
    scene.models.back().position->velocity = {0.5, 0, 0, 0};
  }
  // Passes through the gap before the first, where that proposes to be in each tick.
  scene.models.push_back(robot("thin", {0.115, 0.4, 0, -geom::kPi / 2}, {0.2, 0.02, 0.2}));
  scene.models.back().position->velocity = {0.5, 0, 0, 0};
  const auto engine = engine_of(scene);
  const world::World& world = engine->world();
  for (int tick = 1; tick <= 16; ++tick) {
    engine->step();
    for (std::uint32_t k = 0; k < 3; ++k) {
      EXPECT_EQ(world.positions.stall[{k}], 1) << k;
      EXPECT_EQ(world.models.X_WM[{1 + k}].x, -0.23 * k);
    }
    EXPECT_NEAR(world.models.X_WM[{4}].y, 0.4 - 0.05 * tick, 1e-9);
  }
}

TEST(Motion, touching_is_free_and_a_wall_stops_a_robot_dead) {
  scene::SceneDesc scene;
  scene.models.push_back(robot("r", {}, {0.2, 0.2, 0.2}));
  scene.models.push_back(box("wall", {0.55, 0, 0, 0}, {0.1, 2, 1}));
  const auto engine = engine_of(scene);
  world::World& world = engine->world();
  world::command_velocity(world, {0}, {1, 0, 0, 0});
  for (int tick = 0; tick < 4; ++tick) engine->step();
  EXPECT_NEAR(world.models.X_WM[{0}].x, 0.4, 1e-9);  // its front at the wall
  EXPECT_EQ(world.positions.stall[{0}], 0);
  engine->step();
  EXPECT_NEAR(world.models.X_WM[{0}].x, 0.4, 1e-9);
  EXPECT_EQ(world.positions.stall[{0}], 1);
  world::command_velocity(world, {0}, {-1, 0, 0, 0});
  engine->step();
  EXPECT_NEAR(world.models.X_WM[{0}].x, 0.3, 1e-9);
  EXPECT_EQ(world.positions.stall[{0}], 0);
}

TEST(Motion, a_fast_robot_does_not_jump_a_thin_wall) {
  scene::SceneDesc scene;
  scene.models.push_back(robot("r", {}, {0.2, 0.2, 0.2}));
  scene.models[0].position->velocity = {50, 0, 0, 0};
  scene.models[0].position->velocity_bounds[0] = {-100, 100};
  scene.models.push_back(box("wall", {3.1, 0, 0, 0}, {0.001, 2, 1}));
  const auto engine = engine_of(scene);
  for (int tick = 0; tick < 5; ++tick) engine->step();
  EXPECT_EQ(engine->world().models.X_WM[{0}].x, 0);
  EXPECT_EQ(engine->world().positions.stall[{0}], 1);
}

TEST(Motion, what_is_above_or_does_not_collide_is_passed) {
  scene::SceneDesc scene;
  scene.models.push_back(robot("r", {}, {0.2, 0.2, 0.2}));
  scene.models.push_back(box("bridge", {0.5, 0, 0.2, 0}, {0.1, 2, 1}));
  scene.models.push_back(box("ghost", {0.5, 0, 0, 0}, {0.1, 2, 1}));
  scene.models.back().obstacle_return = false;
  scene.models[0].position->velocity = {1, 0, 0, 0};
  const auto engine = engine_of(scene);
  for (int tick = 0; tick < 10; ++tick) engine->step();
  EXPECT_NEAR(engine->world().models.X_WM[{0}].x, 1, 1e-9);
}

TEST(Motion, children_collide_with_their_parent) {
  scene::SceneDesc scene;
  scene.models.push_back(robot("r", {}, {0.2, 0.2, 0.2}));
  scene.models.push_back(box("arm", {0.3, 0, 0, 0}, {0.4, 0.05, 0.1}));
  scene.models.back().parent = 0;
  scene.models.push_back(box("wall", {0.65, 0, 0, 0}, {0.1, 2, 1}));
  scene.models[0].position->velocity = {1, 0, 0, 0};
  const auto engine = engine_of(scene);
  for (int tick = 0; tick < 3; ++tick) engine->step();
  EXPECT_NEAR(engine->world().models.X_WM[{0}].x, 0.1, 1e-9);
  EXPECT_EQ(engine->world().positions.stall[{0}], 1);
  EXPECT_NEAR(engine->world().models.X_WM[{1}].x, 0.4, 1e-9);
}

TEST(Motion, robots_that_start_in_each_other_or_in_a_wall_can_leave) {
  scene::SceneDesc scene;
  scene.models.push_back(robot("a", {}, {0.4, 0.4, 0.2}));
  scene.models.push_back(robot("b", {}, {0.4, 0.4, 0.2}));
  scene.models.push_back(robot("c", {5, 0, 0, 0}, {0.4, 0.4, 0.2}));
  scene.models.push_back(box("wall", {5.15, 0, 0, 0}, {0.1, 2, 1}));
  scene.models[0].position->velocity = {0.5, 0, 0, 0};
  scene.models[2].position->velocity = {-0.5, 0, 0, 0};
  const auto engine = engine_of(scene);
  for (int tick = 0; tick < 20; ++tick) engine->step();
  EXPECT_NEAR(engine->world().models.X_WM[{0}].x, 1, 1e-9);
  EXPECT_NEAR(engine->world().models.X_WM[{2}].x, 4, 1e-9);
}

TEST(Motion, a_robot_in_a_wall_does_not_get_deeper) {
  scene::SceneDesc scene;
  scene.models.push_back(robot("c", {5, 0, 0, 0}, {0.4, 0.4, 0.2}));
  scene.models.push_back(box("wall", {5.25, 0, 0, 0}, {0.2, 2, 1}));
  scene.models[0].position->velocity = {0.5, 0, 0, 0};
  const auto engine = engine_of(scene);
  for (int tick = 0; tick < 20; ++tick) engine->step();
  EXPECT_LT(engine->world().models.X_WM[{0}].x, 5.2);
}

TEST(Motion, a_robot_put_elsewhere_is_felt_there_in_the_same_tick) {
  scene::SceneDesc scene;
  scene.models.push_back(robot("r", {}, {0.2, 0.2, 0.2}));
  scene.models.push_back(box("wall", {5, 0, 0, 0}, {0.1, 2, 1}));
  scene.models.push_back(robot("q", {0, 5, 0, 0}, {0.2, 0.2, 0.2}));
  scene.models[0].position->velocity = {1, 0, 0, 0};
  const auto engine = engine_of(scene);
  world::World& world = engine->world();
  engine->step();
  world::set_pose(world, {1}, {0.25, 0, 0, 0});
  engine->step();
  EXPECT_EQ(world.positions.stall[{0}], 1);
  world::set_pose(world, {1}, {5, 0, 0, 0});
  world::set_pose(world, {2}, {0.35, 0, 0, 0});
  engine->step();
  EXPECT_EQ(world.positions.stall[{0}], 1);
}

TEST(Motion, exact_odometry_equals_the_true_motion) {
  for (const scene::Drive drive : {scene::Drive::kDiff, scene::Drive::kOmni, scene::Drive::kCar}) {
    scene::SceneDesc scene;
    scene.models.push_back(robot("r", {1, 2, 0, 0.5}, {0.2, 0.2, 0.2}, drive));
    scene.models[0].position->localization = scene::Localization::kOdometry;
    scene.models[0].position->velocity = {0.3, 0.1, 0, 0.2};
    const auto engine = engine_of(scene);
    for (int tick = 0; tick < 100; ++tick) engine->step();
    const geom::Pose believed = engine->world().positions.X_OM[{0}];
    const geom::Pose truth = geom::compose(geom::inverse({1, 2, 0, 0.5}), engine->world().models.X_WM[{0}]);
    EXPECT_NEAR(believed.x, truth.x, 1e-9);
    EXPECT_NEAR(believed.y, truth.y, 1e-9);
    EXPECT_NEAR(believed.a, truth.a, 1e-9);
  }
}

TEST(Motion, the_largest_commands_leave_a_robot_somewhere) {
  for (const scene::Drive drive : {scene::Drive::kDiff, scene::Drive::kOmni, scene::Drive::kCar}) {
    scene::SceneDesc scene;
    scene.models.push_back(robot("r", {}, {0.2, 0.2, 0.2}, drive));
    scene.models[0].position->wheelbase = 0.3;
    const auto engine = engine_of(scene);
    world::World& world = engine->world();
    const auto expect_somewhere = [&](bool taken) {
      EXPECT_TRUE(taken);
      for (int tick = 0; tick < 5; ++tick) engine->step();
      EXPECT_TRUE(world::is_place(world.models.X_WM[{0}]) && world::is_place(world.positions.X_OM[{0}]));
    };
    expect_somewhere(world::command_velocity(world, {0}, {1e308, -1e308, 0, 1e308}));
    expect_somewhere(world::command_heading(world, {0}, -1e308, 1e308));
    expect_somewhere(world::set_odometry(world, {0}, {1e9, -1e9, 0, 1e308}));
    expect_somewhere(world::command_position(world, {0}, {-1e9, 1e9, 0, -1e308}));
  }
}

TEST(Motion, odometry_stands_still_while_the_robot_is_stalled) {
  scene::SceneDesc scene;
  scene.models.push_back(robot("r", {}, {0.2, 0.2, 0.2}));
  scene.models[0].position->localization = scene::Localization::kOdometry;
  scene.models[0].position->velocity = {1, 0, 0, 0};
  scene.models.push_back(box("wall", {0.55, 0, 0, 0}, {0.1, 2, 1}));
  const auto engine = engine_of(scene);
  for (int tick = 0; tick < 10; ++tick) engine->step();
  EXPECT_NEAR(engine->world().positions.X_OM[{0}].x, 0.4, 1e-9);
}

TEST(Motion, what_nobody_subscribed_or_has_its_motors_off_stands) {
  scene::SceneDesc scene;
  scene.models.push_back(robot("r", {}, {0.2, 0.2, 0.2}));
  scene.models[0].alwayson = false;
  scene.models[0].position->velocity = {1, 0, 0, 0};
  const auto engine = engine_of(scene);
  world::World& world = engine->world();
  engine->step();
  EXPECT_EQ(world.models.X_WM[{0}].x, 0);
  world::subscribe(world, {0});
  engine->step();
  EXPECT_NEAR(world.models.X_WM[{0}].x, 0.1, 1e-12);
  world.positions.motor_on[{0}] = 0;
  engine->step();
  EXPECT_NEAR(world.models.X_WM[{0}].x, 0.1, 1e-12);
}

TEST(Motion, every_drive_reaches_a_goal_by_position_control) {
  for (const scene::Drive drive : {scene::Drive::kDiff, scene::Drive::kOmni, scene::Drive::kCar}) {
    scene::SceneDesc scene;
    scene.models.push_back(robot("r", {1, 1, 0, 2}, {0.2, 0.2, 0.2}, drive));
    scene.models[0].position->wheelbase = 0.3;
    const auto engine = engine_of(scene);
    world::World& world = engine->world();
    ASSERT_TRUE(world::command_position(world, {0}, {-1, 2.5, 0, 1}));
    for (int tick = 0; tick < 300; ++tick) engine->step();
    EXPECT_NEAR(world.models.X_WM[{0}].x, -1, 0.05);
    EXPECT_NEAR(world.models.X_WM[{0}].y, 2.5, 0.05);
    if (drive != scene::Drive::kCar) {
      EXPECT_NEAR(world.models.X_WM[{0}].a, 1, 0.01);
    }
  }
}

TEST(Motion, a_goal_is_in_the_frame_of_what_the_robot_believes) {
  scene::SceneDesc scene;
  scene.models.push_back(robot("r", {1, 1, 0, geom::kPi / 2}, {0.2, 0.2, 0.2}, scene::Drive::kOmni));
  const auto engine = engine_of(scene);
  world::World& world = engine->world();
  ASSERT_TRUE(world::set_odometry(world, {0}, {}));
  ASSERT_TRUE(world::command_position(world, {0}, {1, 0, 0, 0}));
  for (int tick = 0; tick < 300; ++tick) engine->step();
  EXPECT_NEAR(world.models.X_WM[{0}].x, 1, 1e-3);
  EXPECT_NEAR(world.models.X_WM[{0}].y, 2, 1e-3);
}

TEST(Motion, every_drive_keeps_a_heading_forwards_and_backwards) {
  for (const scene::Drive drive : {scene::Drive::kDiff, scene::Drive::kOmni, scene::Drive::kCar}) {
    for (const double speed : {0.5, -0.5}) {
      scene::SceneDesc scene;
      scene.models.push_back(robot("r", {0, 0, 0, 3}, {0.2, 0.2, 0.2}, drive));
      scene.models[0].position->wheelbase = 0.3;
      const auto engine = engine_of(scene);
      world::World& world = engine->world();
      ASSERT_TRUE(world::command_heading(world, {0}, speed, -2.5));  // the short way round leads past pi
      for (int tick = 0; tick < 100; ++tick) engine->step();
      EXPECT_NEAR(world.models.X_WM[{0}].a, -2.5, 0.01);
      EXPECT_NEAR(world.positions.velocity[{0}].x, speed, 1e-3);
    }
  }
}

TEST(Motion, a_robot_that_another_one_carries_moves_with_it_and_by_itself) {
  scene::SceneDesc scene;
  scene.models.push_back(robot("ship", {1, 0, 0, geom::kPi / 2}, {2, 1, 0.2}));
  scene.models.push_back(robot("boat", {0.5, 0, 0.2, 0}, {0.2, 0.2, 0.2}));
  scene.models.push_back(robot("duck", {0, 0, 0.2, 0}, {0.1, 0.1, 0.1}));
  scene.models[1].parent = 0;
  scene.models[2].parent = 1;
  scene.models[0].position->velocity = {0.5, 0, 0, 0};
  scene.models[1].position->velocity = {-0.2, 0, 0, 0};
  scene.models[2].position->velocity = {0, 0, 0, 0.3};
  std::vector<std::uint64_t> hashes;
  for (const unsigned workers : {1u, 2u, 4u}) {
    const auto engine = engine_of(scene, workers);
    for (int tick = 0; tick < 10; ++tick) engine->step();
    const world::World& world = engine->world();
    EXPECT_NEAR(world.models.X_WM[{0}].y, 0.5, 1e-9);
    EXPECT_NEAR(world.models.X_PM[{1}].x, 0.3, 1e-9);
    EXPECT_NEAR(world.models.X_PM[{2}].a, 0.3, 1e-9);
    geom::Pose expected = world.models.X_WM[{0}];
    for (std::uint32_t row = 1; row < 3; ++row) {
      expected = geom::compose(expected, world.models.X_PM[{row}]);
      EXPECT_NEAR(world.models.X_WM[{row}].x, expected.x, 1e-9);
      EXPECT_NEAR(world.models.X_WM[{row}].y, expected.y, 1e-9);
      EXPECT_NEAR(world.models.X_WM[{row}].a, expected.a, 1e-9);
      EXPECT_NEAR(world.positions.X_OM[{row}].y, expected.y, 1e-9) << "gps";
      EXPECT_EQ(world.positions.stall[{row}], 0);
    }
    hashes.push_back(world.hash());
  }
  EXPECT_EQ(hashes, std::vector<std::uint64_t>(3, hashes[0]));
}

TEST(Motion, what_a_robot_was_told_of_its_pose_lasts_with_gps_too) {
  scene::SceneDesc scene;
  scene.models.push_back(robot("r", {1, 2, 0, geom::kPi / 2}, {0.2, 0.2, 0.2}));
  scene.models[0].position->velocity = {0.5, 0, 0, 0};
  const auto engine = engine_of(scene);
  world::World& world = engine->world();
  ASSERT_TRUE(world::set_odometry(world, {0}, {5, 6, 0, 0}));
  for (int tick = 0; tick < 10; ++tick) engine->step();
  EXPECT_NEAR(world.positions.X_OM[{0}].x, 5.5, 1e-9);
  EXPECT_NEAR(world.positions.X_OM[{0}].y, 6, 1e-9);
  EXPECT_NEAR(world.models.X_WM[{0}].y, 2.5, 1e-9);
}

TEST(Engine, the_hashes_are_the_same_for_any_number_of_workers) {
  for (const testing::Sensing sensing : {testing::Sensing::kSonar, testing::Sensing::kLaser}) {
    const scene::SceneDesc scene = testing::crowd(300, sensing);
    std::vector<std::pair<std::uint64_t, std::uint64_t>> hashes;
    for (const unsigned workers : {1u, 1u, 2u, 4u}) {
      const auto engine = engine_of(scene, workers);
      for (int tick = 0; tick < 20; ++tick) engine->step();
      hashes.emplace_back(engine->world().hash(), engine->world().sensed_hash());
    }
    for (const auto& pair : hashes) EXPECT_EQ(pair, hashes[0]);
  }
}

// The bench prints the same hashes from an optimised build. A change of a result changes them: put the new
// ones here, and say in the commit why the result changed.
TEST(Engine, the_hashes_are_those_on_record_in_every_build) {
  const struct {
    testing::Sensing sensing;
    std::uint64_t hash, sensed_hash;
  } expected[] = {{testing::Sensing::kSonar, 0x40d4d5f736b79e80, 0x412840eafcea364e},
                  {testing::Sensing::kLaser, 0x5a2af09861662e2b, 0xf61dad83fabd7a06}};
  for (const auto& [sensing, hash, sensed_hash] : expected) {
    const scene::SceneDesc scene = testing::crowd(100, sensing);
    auto engine = make_engine(scene, {.seed = 1, .workers = 2});
    ASSERT_TRUE(engine.ok());
    for (int tick = 0; tick < 20; ++tick) (*engine)->step();
    EXPECT_EQ((*engine)->world().hash(), hash);
    EXPECT_EQ((*engine)->world().sensed_hash(), sensed_hash);
  }
}

TEST(Engine, refuses_a_scene_that_cannot_run) {
  scene::SceneDesc scene;
  scene.path = "a.world";
  scene.interval = 0;
  EXPECT_EQ(make_engine(scene, {}).error().line(), "a.world: the interval of a tick must be above 0");
  scene.interval = 0.1;
  EXPECT_TRUE(make_engine(scene, {}).ok());
  scene.models.push_back(box("b", {0, 0, 0, std::nan("")}, {1, 1, 1}));
  EXPECT_FALSE(make_engine(scene, {}).ok());
}

}  // namespace
}  // namespace playhouse::stage
