#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/arena/testing_runs.h"
#include "playhouse/world/saving/as_scene.h"

namespace playhouse::arena {
namespace {

constexpr const char* kWorld = R"(
interval_sim 100
define rover position( size [0.4 0.4 0.3] localization "odom" odom_error [0 0 0 0]
  ranger( sensor( samples 9 fov 90 range [0 8] ) ) )
rover( name "a" pose [0 0 0 0] )
rover( name "b" pose [0 3 0 90] )
model( name "box" pose [1 0 0 0] size [0.3 0.3 0.3] gripper_return 1 mass 2 )
model( name "high" pose [0 -3 1 0] size [0.3 0.3 0.3] gripper_return 1 )
model( name "wall" pose [3 0 0 0] size [0.1 4 1] )
)";

scene::SceneDesc scene_of(const char* text) {
  config::MemoryFiles files({{std::string("w.world"), text}});
  Result<scene::SceneDesc> scene = scene::load_world_text(text, "w.world", files);
  EXPECT_TRUE(scene) << scene.error().line();
  return std::move(*scene);
}

class ArenaTest : public ArenaRun {
 protected:
  void start(const char* text, unsigned workers = 1) { ArenaRun::start(scene_of(text), workers); }
};

TEST_F(ArenaTest, what_physics_takes_bodies_for_can_be_told) {
  start(kWorld);
  const world::PhysicsShapes shapes = engine_->physics_shapes();
  ASSERT_EQ(shapes.fixed.size(), 1u);
  EXPECT_EQ(shapes.fixed[0].size(), 8u);
  for (const geom::Vec3& p : shapes.fixed[0]) {
    EXPECT_NEAR(std::fabs(p.x - 3), 0.05, 1e-9) << "the wall, in the world";
    EXPECT_NEAR(std::fabs(p.y), 2, 1e-9);
  }
  ASSERT_EQ(shapes.bodies.size(), 4u);
  const auto& rover = shapes.bodies[1];
  EXPECT_EQ(rover.model, world().id(world().find("b")));
  ASSERT_EQ(rover.solids.size(), 1u);
  for (const geom::Vec3& p : rover.solids[0]) {
    EXPECT_NEAR(std::fabs(p.y), 0.2, 1e-9) << "in its own frame";
    EXPECT_GT(p.z, 0.02) << "above the clearance of its wheels";
  }
}

TEST_F(ArenaTest, both_engines_tell_the_same_outlines) {
  start(kWorld);
  auto flat = stage::make_engine(*scene_, {});
  ASSERT_TRUE(flat);
  const world::PhysicsShapes shapes = engine_->physics_shapes(), outlines = (*flat)->physics_shapes();
  ASSERT_EQ(outlines.fixed, shapes.fixed);
  ASSERT_EQ(outlines.bodies.size(), shapes.bodies.size());
  for (std::size_t k = 0; k < shapes.bodies.size(); ++k) {
    EXPECT_EQ(outlines.bodies[k].model, shapes.bodies[k].model);
    ASSERT_EQ(outlines.bodies[k].solids.size(), shapes.bodies[k].solids.size());
    ASSERT_EQ(outlines.bodies[k].solids[0].size(), shapes.bodies[k].solids[0].size());
    for (std::size_t i = 0; i < shapes.bodies[k].solids[0].size(); ++i) {
      EXPECT_EQ(outlines.bodies[k].solids[0][i].x, shapes.bodies[k].solids[0][i].x);
      EXPECT_EQ(outlines.bodies[k].solids[0][i].y, shapes.bodies[k].solids[0][i].y);
    }
  }
}

TEST_F(ArenaTest, robots_push_boxes_until_a_wall_stops_them_both) {
  start(kWorld);
  drive("a", {0.5, 0, 0, 0});
  run(3);
  EXPECT_NEAR(pose("a").x, 1.5, 0.1) << "slower while it gets the box going";
  EXPECT_NEAR(pose("box").x, pose("a").x + 0.35, 0.03);
  EXPECT_EQ(world().positions.stall[{0}], 0);
  run(4);
  EXPECT_NEAR(pose("box").x, 2.8, 0.02);
  EXPECT_NEAR(pose("a").x, 2.45, 0.02);
  EXPECT_EQ(world().positions.stall[{0}], 1);
  EXPECT_NEAR(world().positions.X_OM[{0}].x, pose("a").x, 0.1);
}

TEST_F(ArenaTest, what_is_in_the_air_falls_rests_and_is_woken_by_who_touches_it) {
  start(kWorld);
  run(2);
  const world::ModelRow high = world().find("high");
  EXPECT_NEAR(pose("high").z, 0, 2e-3);
  EXPECT_GE(world().models.still[high], 5u);
  EXPECT_EQ(world().models.V_WM[high], geom::SpatialVelocity{});
  const geom::Pose rested = pose("high");
  run(1);
  EXPECT_EQ(pose("high"), rested) << "to the bit";
  ASSERT_TRUE(world::set_pose(world(), world().find("a"), {-1, -3, 0, 0}));
  drive("a", {0.5, 0, 0, 0});
  run(3);
  EXPECT_GT(pose("high").x, 0.2);
}

TEST_F(ArenaTest, a_stack_falls_when_its_base_is_taken_away) {
  start(R"(
model( name "base" pose [0 0 0 0] size [0.5 0.5 0.5] gripper_return 1 )
model( name "top" pose [0 0 0.5 0] size [0.4 0.4 0.4] gripper_return 1 )
)");
  run(2);
  EXPECT_NEAR(pose("top").z, 0.5, 5e-3);
  ASSERT_TRUE(world::despawn(world(), world().id(world().find("base"))));
  run(2);
  EXPECT_NEAR(pose("top").z, 0, 5e-3);
}

TEST_F(ArenaTest, a_box_that_is_pushed_off_a_table_tumbles) {
  start(R"(
model( name "table" pose [0 0 0 0] size [1 1 0.7] )
model( name "box" pose [0.45 0 0.7 0] size [0.3 0.2 0.3] gripper_return 1 )
)");
  run(0.5);
  world::wake(world().models);
  world().models.V_WM.set(world().find("box"), {{1.2, 0, 0}, {}});
  run(0.6);
  EXPECT_LT(pose("box").z, 0.6);
  EXPECT_GT(world().models.tilt_WM[world().find("box")].y, 0.3);
}

/// A plank of 4 m whose bottom is 1 m high at its middle, with its end at -x up by 0.25 rad.
TEST_F(ArenaTest, a_fixed_plank_is_met_as_it_is_tilted_by_beams_and_by_bodies) {
  start(R"(
model( name "plank" pose [0 0 1 0] size [4 2 0.1] )
model( name "crate" pose [0 0 3 0] size [0.2 0.2 0.2] gripper_return 1 )
ranger( name "eye" pose [-5 0 1.3 0] size [0 0 0] alwayson 1 sensor( range [0 10] fov 0 samples 1 ) )
)");
  const geom::Tilt tilt{0, 0.25};
  ASSERT_TRUE(world::set_spatial_pose(world(), world().find("plank"), {{0, 0, 1, 0}, tilt}));
  const geom::Quaternion q = geom::orientation(0, tilt);
  const geom::Vec3 on_top = geom::Vec3{0, 0, 1} + q * geom::Vec3{0.5, 0, 0.1};
  ASSERT_TRUE(
      world::set_spatial_pose(world(), world().find("crate"), {{on_top.x, on_top.y, on_top.z, 0}, tilt}));
  run(2);
  EXPECT_NEAR(world().sensors.ranges[{0}], 5 - 0.31 / std::tan(tilt.y), 1e-5);  // from the middle of the eye
  EXPECT_NEAR(pose("crate").x, on_top.x, 0.01);
  EXPECT_NEAR(pose("crate").z, on_top.z, 0.01);
  EXPECT_NEAR(world().models.tilt_WM[world().find("crate")].y, tilt.y, 0.01);
}

TEST_F(ArenaTest, ticks_that_nothing_would_interrupt_are_refused) {
  const scene::SceneDesc scene = scene_of("interval_sim 20000\n");
  const auto made = make_engine(scene, {.seed = 1});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().line(),
            "w.world: interval_sim 20000 is too long for physics, which takes at most 10000");
}

TEST_F(ArenaTest, actuators_stall_at_what_cannot_give_way_and_go_back) {
  start(R"(
model( name "wall" pose [1.6 0 0 0] size [0.2 4 1] )
model( name "frame" pose [0 0 0 0] size [0.2 0.2 1]
  actuator( name "door" type "linear" axis [1 0 0] min_position 0 max_position 1.5 max_speed 0.5
            pose [0.3 0 -1 0] size [0.4 1 0.8] ) )
model( name "box" pose [0.8 0 0 0] size [0.3 0.3 0.3] gripper_return 1 mass 1 )
model( name "roof" pose [0 5 2 0] size [1 1 0.2] )
model( name "shaft" pose [0 5 0 0] size [0.1 0.1 0.1]
  actuator( name "lift" type "linear" axis [0 0 1] min_position 0 max_position 3 max_speed 0.3
            pose [0 0 0 0] size [1 1 0.1] ) )
model( name "crate" pose [0 5 0.2 0] size [0.5 0.5 0.5] gripper_return 1 mass 40 )
)");
  const auto row_of = [this](const char* name) {
    const world::ModelRow model = world().find(name);
    world::subscribe(world(), model);
    return world::ActuatorRow(world().models.part[model]);
  };
  const world::ActuatorRow door = row_of("frame.door"), lift = row_of("shaft.lift");
  const auto go = [&](double door_to, double lift_to) {
    ASSERT_TRUE(world::command_joint_position(world(), door, door_to));
    ASSERT_TRUE(world::command_joint_position(world(), lift, lift_to));
    run(10);
  };
  go(1.5, 3);
  constexpr double kWay =
      0.05;  // of the door in a tick: so deep it may press before it stalls, on both sides
  EXPECT_NEAR(pose("box").x, 1.5 - 0.15, kWay + 0.03) << "at the wall, not beyond it";
  EXPECT_NEAR(pose("frame.door").x, 1.5 - 0.3 - 0.2, 2 * kWay + 0.03);
  EXPECT_NEAR(world().actuators.position[door], pose("frame.door").x - 0.3, 1e-9);
  EXPECT_EQ(world().actuators.stall[door], 1);
  EXPECT_NEAR(pose("crate").z, 2 - 0.5, 0.05) << "below the roof";
  EXPECT_EQ(world().actuators.stall[lift], 1);
  go(0, 0);
  EXPECT_NEAR(pose("frame.door").x, 0.3, 0.01);
  EXPECT_EQ(world().actuators.stall[door], 0);
  EXPECT_NEAR(pose("crate").z, pose("shaft.lift").z + 0.1, 0.01);
  EXPECT_EQ(world().actuators.stall[lift], 0);
}

TEST_F(ArenaTest, boxes_lie_still_on_every_side_and_stacks_stand_in_ticks_of_one_step) {
  start(R"(
interval_sim 10
define crate model( size [0.5 0.5 0.5] gripper_return 1 mass 10 material "wood" )
crate( name "below" pose [0 0 0 0] )
crate( name "tumbles" pose [0.3 0.2 3 20] )
crate( name "c0" pose [5 0 0 0] )
crate( name "c1" pose [5 0 0.5 0] )
crate( name "c2" pose [5 0 1 0] )
crate( name "c3" pose [5 0 1.5 0] )
crate( name "c4" pose [5 0 2 0] )
)");
  for (int tick = 0; tick < 1500; ++tick) engine_->step();
  for (const char* name : {"below", "tumbles", "c0", "c1", "c2", "c3", "c4"}) {
    const world::ModelRow row = world().find(name);
    EXPECT_EQ(world().models.V_WM[row], geom::SpatialVelocity{}) << name;
  }
  EXPECT_NEAR(pose("c4").z, 2, 0.02);
  EXPECT_LT(std::hypot(pose("c4").x - 5, pose("c4").y), 0.01);
}

// Its wheels and mass are planned as the population changes: also where its arm is out by then.
TEST_F(ArenaTest, a_robot_with_its_arm_out_goes_on_from_any_state) {
  start(R"(
model( name "step" pose [2 0 0 0] size [0.4 2 0.02] )
position( name "r" pose [0 0 0 0] size [0.5 0.4 0.2] drive "diff"
  actuator( name "arm" type "linear" axis [1 0 0] size [0.5 0.1 0.1] min_position 0 max_position 0.5 max_speed 0.5 ) )
)");
  const auto subscribe = [](world::World& world) {
    for (const char* name : {"r", "r.arm"}) world::subscribe(world, world.find(name));
  };
  const auto command = [&](world::World& world, int tick) {
    const world::ModelRow arm = world.find("r.arm"), robot = world.find("r");
    if (tick == 0) subscribe(world);
    const world::ActuatorRow joint = world.models.part[arm];
    ASSERT_TRUE(world::command_joint_position(world, joint, 0.5));
    ASSERT_TRUE(world::command_velocity(world, world.position(world.id(robot)), {0.3, 0, 0, 0.05}));
  };
  expect_the_same_run(80, 7, command, subscribe);
  EXPECT_GT(pose("r").x, 0.5);
}

TEST_F(ArenaTest, what_rests_on_a_lift_comes_down_with_it) {
  start(R"(
model( name "shaft" pose [0 0 0 0] size [0.1 0.1 0.1]
  actuator( name "lift" type "linear" axis [0 0 1] min_position 0 max_position 2 max_speed 3 size [1 1 0.1] ) )
model( name "crate" pose [0 0 0.3 0] size [0.5 0.5 0.5] gripper_return 1 mass 40 )
model( name "parcel" pose [0 0 0.8 0] size [0.2 0.2 0.2] gripper_return 1 mass 2 )
)");
  const world::ModelRow lift = world().find("shaft.lift");
  world::subscribe(world(), lift);
  const world::ActuatorRow row = world().models.part[lift];
  ASSERT_TRUE(world::command_joint_velocity(world(), row, 0.2));
  run(20);
  ASSERT_NEAR(pose("shaft.lift").z, 2, 0.2);
  const world::ModelRow crate = world().find("crate");
  ASSERT_GE(world().models.still[crate], 5u) << "it sleeps";
  ASSERT_TRUE(world::command_joint_velocity(world(), row, -3));
  run(5);
  EXPECT_NEAR(pose("crate").z, pose("shaft.lift").z + 0.1, 0.01);
  EXPECT_NEAR(pose("parcel").z, pose("crate").z + 0.5, 0.01);
}

TEST_F(ArenaTest, a_robot_that_stands_keeps_its_place_under_a_load) {
  for (const char* mass : {"5", "50", "100"}) {
    start((std::string(R"(position( name "cart" size [0.5 0.4 0.22] mass 23 drive "diff" )
model( name "load" pose [0 0 0.22 0] size [0.3 0.3 0.3] gripper_return 1 mass )") +
           mass + " )\n")
              .c_str());
    drive("cart", {});
    run(20);
    const geom::Pose& cart = pose("cart");
    EXPECT_LT(std::hypot(cart.x, cart.y), 0.02) << mass;
    EXPECT_NEAR(pose("load").z, 0.22, 0.01) << mass;
  }
}

TEST_F(ArenaTest, robots_come_out_of_walls_onto_the_ground_in_long_ticks_too) {
  start(R"(
interval_sim 1000
model( name "wall" pose [0 0 0 0] size [0.5 4 1] )
position( name "stuck" pose [0.1 0 0 0] size [0.4 0.4 0.2] )
position( name "below" pose [5 0 0 0] size [0.4 0.4 0.2] )
model( name "weight" pose [5 0 3 0] size [0.5 0.5 0.5] gripper_return 1 mass 1000 )
)");
  for (int k = 0; k < 20; ++k) engine_->step();
  for (const char* name : {"stuck", "below"}) EXPECT_GT(pose(name).z, -0.05) << name;
}

TEST_F(ArenaTest, who_was_pressed_into_the_ground_comes_up_again) {
  start(R"(
interval_sim 500
actuator( name "press" type "linear" axis [0 0 -1] size [3 3 0.1] pose [0 0 2.5 0] min_position 0 max_position 2 max_speed 0.5 )
position( name "ann" drive "walk" size [0.3 0.5 1.75] mass 75 )
)");
  const world::ModelRow press = world().find("press");
  world::subscribe(world(), press);
  const world::ActuatorRow row = world().models.part[press];
  ASSERT_TRUE(world::command_joint_position(world(), row, 2));
  for (int tick = 0; tick < 20; ++tick) engine_->step();
  EXPECT_LT(pose("ann").z, -0.1) << "it is pressed";
  ASSERT_TRUE(world::command_joint_position(world(), row, 0));
  for (int tick = 0; tick < 20; ++tick) engine_->step();
  EXPECT_NEAR(pose("ann").z, 0, 0.01);
}

TEST_F(ArenaTest, shapes_are_of_those_who_are_there_also_before_the_next_tick) {
  start(R"(
define cart position( size [0.4 0.4 0.2] model( size [0.1 0.1 0.1] ) )
cart( name "a" pose [0 0 0 0] )
cart( name "b" pose [2 0 0 0] )
cart( name "c" pose [4 0 0 0] )
)");
  run(1);
  ASSERT_TRUE(world::despawn(world(), world().id(world().find("a"))));
  EXPECT_EQ(engine_->physics_shapes().bodies.size(), 2u);
  run(1);
  EXPECT_EQ(engine_->physics_shapes().bodies.size(), 2u);
}

TEST_F(ArenaTest, actuators_push_what_is_in_the_way) {
  start(R"(
model( name "wall" pose [0 0 0 0] size [0.2 0.2 1]
  actuator( name "door" type "linear" axis [1 0 0] min_position 0 max_position 1 max_speed 0.5
            pose [0.3 0 -1 0] size [0.4 0.1 0.8] ) )
model( name "box" pose [0.8 0 0 0] size [0.3 0.3 0.3] gripper_return 1 mass 1 )
)");
  const world::ModelRow door = world().find("wall.door");
  world::subscribe(world(), door);
  ASSERT_TRUE(world::command_joint_position(world(), world().models.part[door], 1));
  run(8);
  EXPECT_NEAR(pose("wall.door").x, 1.3, 0.01);
  EXPECT_NEAR(pose("box").x, 1.3 + 0.2 + 0.15, 0.05);
}

TEST_F(ArenaTest, every_drive_goes_where_it_is_told) {
  start(R"(
define base position( size [0.5 0.4 0.3] localization "gps" )
base( name "diff" pose [0 0 0 0] drive "diff" )
base( name "omni" pose [0 5 0 0] drive "omni" )
base( name "car" pose [0 10 0 0] drive "car" wheelbase 0.4 )
)");
  drive("diff", {0.4, 0, 0, 0.2});
  drive("omni", {0, 0.4, 0, 0});
  drive("car", {0.4, 0, 0, 0.1});
  run(5);
  const world::ByModel<geom::Pose> here = world().models.X_WM;
  auto made = stage::make_engine(*scene_, {});
  engine_ = std::move(*made);
  drive("diff", {0.4, 0, 0, 0.2});
  drive("omni", {0, 0.4, 0, 0});
  drive("car", {0.4, 0, 0, 0.1});
  run(5);
  for (const world::ModelRow row : here.rows()) {
    const geom::Pose& there = world().models.X_WM[row];
    EXPECT_NEAR(here[row].x, there.x, 0.04) << row.index;
    EXPECT_NEAR(here[row].y, there.y, 0.04) << row.index;
    EXPECT_NEAR(here[row].a, there.a, 0.02) << row.index;
  }
}

TEST_F(ArenaTest, who_walks_climbs_steps_stays_upright_and_pushes) {
  start(R"(
define person position( drive "walk" size [0.3 0.5 1.75] mass 75 )
person( name "climber" pose [0 0 0 0] )
person( name "pusher" pose [0 5 0 90] )
person( name "blocked" pose [0 -5 0 0] )
model( name "step" pose [1.5 0 0 0] size [1 2 0.2] )
model( name "table" pose [2 0 0 0] size [1 2 0.4] )
model( name "box" pose [0 6 0 0] size [0.5 0.5 0.5] gripper_return 1 mass 20 )
model( name "wall" pose [1 -5 0 0] size [0.2 2 1] )
)");
  for (const char* name : {"climber", "pusher", "blocked"}) drive(name, {0.8, 0, 0, 0});
  run(1.5);
  EXPECT_NEAR(pose("climber").z, 0.2, 0.01);
  run(1);
  EXPECT_NEAR(pose("climber").z, 0.4, 0.01);
  run(2.5);
  EXPECT_NEAR(pose("climber").z, 0, 0.01) << "and down again";
  EXPECT_GT(pose("climber").x, 3);
  EXPECT_GT(pose("box").y, 8);
  EXPECT_NEAR(pose("blocked").x, 0.75, 0.01);
  EXPECT_EQ(world().positions.stall[{2}], 1);
  for (std::uint32_t row = 0; row < 3; ++row) EXPECT_EQ(world().models.tilt_WM[{row}], geom::Tilt{});
}

TEST_F(ArenaTest, there_is_no_height_at_which_who_walks_or_drives_goes_through_a_step) {
  const auto goes_over = [this](const std::string& mover, const std::string& step, double speed) {
    start((mover + "model( name \"step\" pose [3 0 0 0] size [4 2 " + step + "] )\n").c_str());
    drive("p", {speed, 0, 0, 0});
    run(3 / speed);
    if (pose("p").x < 1.2) return false;
    EXPECT_NEAR(pose("p").z, std::stod(step), 0.01) << step;
    return true;
  };
  const char *person = "position( name \"p\" drive \"walk\" size [0.3 0.5 1.75] mass 75 )\n",
             *robot = "position( name \"p\" drive \"omni\" size [0.5 0.4 0.25] )\n";
  for (const char* step : {"0.295", "0.3", "0.301", "0.305"}) EXPECT_TRUE(goes_over(person, step, 1));
  for (const char* step : {"0.31", "0.315", "0.35"}) goes_over(person, step, 1);
  for (const char* step : {"0.029", "0.03", "0.031"}) EXPECT_TRUE(goes_over(robot, step, 0.5));
  for (const char* step : {"0.035", "0.04", "0.045", "0.1"}) goes_over(robot, step, 0.5);
}

TEST_F(ArenaTest, is_the_same_run_for_any_number_of_workers_and_from_any_saved_tick) {
  start(kWorld);
  const auto command = [&](world::World& world, int tick) {
    const auto position = [&](const char* name) { return world.position(world.id(world.find(name))); };
    if (tick == 0) {
      for (const char* name : {"a", "b"}) world::subscribe(world, world.find(name));
      world::command_velocity(world, position("a"), {0.5, 0, 0, 0});
      world::command_velocity(world, position("b"), {0.4, 0, 0, 0.3});
    }
    if (tick == 12) ASSERT_TRUE(world::spawn(world, 0, {0, -1, 0, 0}));
    if (tick == 18)
      ASSERT_TRUE(
          world::attach(world, world.id(world.find("high")), world.id(world.find("b")), {0.3, 0, 0, 0}));
    if (tick == 25) ASSERT_TRUE(world::detach(world, world.id(world.find("high"))));
    if (tick == 30) ASSERT_TRUE(world::set_pose(world, world.find("box"), {0, 1, 0.5, 1}));
  };
  expect_the_same_run(45, 3, command, [](world::World& world) {
    for (const char* name : {"a", "b"}) world::subscribe(world, world.find(name));
  });
}

TEST_F(ArenaTest, runs_bodies_that_enclose_nothing) {
  start(R"(
position( name "thin" pose [0 0 0 0] size [0.4 0.4 0.3]
  block( points 4 point[0] [0 0] point[1] [1 1] point[2] [0 0] point[3] [1 1] z [0 1] ) )
model( name "flat" pose [2 0 0 0] size [0.4 0.4 0] gripper_return 1 )
)");
  drive("thin", {0.5, 0, 0, 0});
  run(2);
  EXPECT_NEAR(pose("thin").x, 1, 0.1);
}

TEST_F(ArenaTest, runs_what_no_wheels_carry) {
  start(R"(
position( name "ghost" pose [0 0 0 0] size [0.4 0.4 0.3] obstacle_return 0 )
)");
  drive("ghost", {0.5, 0, 0, 0});
  run(2);
  EXPECT_NEAR(pose("ghost").x, 1, 1e-9);
}

}  // namespace
}  // namespace playhouse::arena
