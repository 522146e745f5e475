#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "playhouse/arena/testing_runs.h"
#include "playhouse/scene/write_world.h"
#include "playhouse/world/population/population.h"
#include "playhouse/world/saving/as_scene.h"

namespace playhouse::arena {
namespace {

constexpr double kRoll = 0.3, kPitch = -0.5, kYaw = 1.1;  // rad; below in degrees

constexpr const char* kTilted = R"(
define wedge model( size [2 1 0.2] tilt [17.188733853924695 -28.64788975654116] )
wedge( name "plank" pose [0 0 1 63.02535746439056] )
define rig model( size [1 1 0.5] gripper_return 1 mass 5 tilt [0 20]
  model( name "arm" pose [0.5 0 0 0] size [1 0.1 0.1] tilt [0 -20] ) )
rig( name "rig" pose [10 0 3 0] )
)";

scene::SceneDesc scene_of(const std::string& text) {
  config::MemoryFiles files({{std::string("w.world"), text}});
  Result<scene::SceneDesc> scene = scene::load_world_text(text, "w.world", files);
  EXPECT_TRUE(scene) << scene.error().line();
  return std::move(*scene);
}

/// R = Rz(yaw) Ry(pitch) Rx(roll), by its matrix.
geom::Vec3 turned(const geom::Vec3& p) {
  const geom::Vec3 x{p.x, std::cos(kRoll) * p.y - std::sin(kRoll) * p.z,
                     std::sin(kRoll) * p.y + std::cos(kRoll) * p.z};
  const geom::Vec3 y{std::cos(kPitch) * x.x + std::sin(kPitch) * x.z, x.y,
                     -std::sin(kPitch) * x.x + std::cos(kPitch) * x.z};
  return {std::cos(kYaw) * y.x - std::sin(kYaw) * y.y, std::sin(kYaw) * y.x + std::cos(kYaw) * y.y, y.z};
}

class TiltTest : public ArenaRun {
 protected:
  geom::SpatialPose spatial(const char* name) {
    return world::pose_in_world(world().models, world().find(name));
  }
  geom::Vec3 point(const char* name, const geom::Vec3& p_M) {
    const geom::SpatialPose X = spatial(name);
    return geom::Vec3{X.X.x, X.X.y, X.X.z} + geom::orientation(X.X.a, X.tilt) * p_M;
  }
};

void expect_near(const geom::Vec3& is, const geom::Vec3& should, double tolerance = 1e-9) {
  EXPECT_NEAR(is.x, should.x, tolerance);
  EXPECT_NEAR(is.y, should.y, tolerance);
  EXPECT_NEAR(is.z, should.z, tolerance);
}

TEST_F(TiltTest, models_are_turned_by_roll_then_pitch_then_heading) {
  ArenaRun::start(scene_of(kTilted));
  for (const geom::Vec3& p : {geom::Vec3{1, 0.5, 0}, geom::Vec3{-1, 0.5, 0.2}, geom::Vec3{0, 0, 1}}) {
    const geom::Vec3 q = turned(p);
    expect_near(point("plank", p), {q.x, q.y, 1 + q.z});
  }
  // The arm is level again: its tilt is in its parent.
  const double pitch = geom::radians(20), up = 0.5;  // on the roof of the rig
  expect_near(point("rig.arm", {1, 0, 0}), {10 + 0.5 * std::cos(pitch) + up * std::sin(pitch) + 1, 0,
                                            3 - 0.5 * std::sin(pitch) + up * std::cos(pitch)});
  // Also for physics.
  const world::PhysicsShapes shapes = engine_->physics_shapes();
  ASSERT_EQ(shapes.fixed.size(), 1u);
  double highest = -1e9;
  for (const geom::Vec3& p : shapes.fixed[0]) highest = std::max(highest, p.z);
  double should = -1e9;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-0.5, 0.5}) should = std::max(should, 1 + turned({x, y, 0.2}).z);
  EXPECT_NEAR(highest, should, 1e-6);
  ASSERT_EQ(shapes.bodies.size(), 1u);
  ASSERT_EQ(shapes.bodies[0].solids.size(), 2u);
  for (const geom::Vec3& p : shapes.bodies[0].solids[1]) {  // of the arm, in the frame of the rig
    const double x = std::cos(pitch) * (p.x - 0.5) + std::sin(pitch) * (p.z - 0.5),
                 z = -std::sin(pitch) * (p.x - 0.5) + std::cos(pitch) * (p.z - 0.5);
    EXPECT_NEAR(std::fabs(x), 0.5, 1e-6);
    EXPECT_NEAR(std::fabs(z - 0.05), 0.05, 1e-6);
  }
}

TEST_F(TiltTest, a_world_file_of_a_run_has_the_tilts_again) {
  ArenaRun::start(
      scene_of(std::string(kTilted) + "model( name \"crate\" pose [0 5 0.5 0] gripper_return 1 )\n"));
  ASSERT_TRUE(world::set_spatial_pose(world(), world().find("crate"), {{0, 5, 0.5, 0.4}, {0.7, -0.9}}));
  ASSERT_TRUE(world::spawn(world(), world().models.desc[world().find("rig")], {20, 0, 3, 0.7}, "more"));
  const scene::SceneDesc standing = world::as_scene(world());
  EXPECT_TRUE(standing.warnings.empty());
  const Result<std::string> text = scene::write_world(standing, "w.world");
  ASSERT_TRUE(text) << text.error().line();
  std::vector<geom::SpatialPose> poses;
  const std::vector<const char*> names{"plank", "rig", "rig.arm", "crate", "more", "more.arm"};
  for (const char* name : names) poses.push_back(spatial(name));
  ArenaRun::start(scene_of(*text));
  for (std::size_t i = 0; i < names.size(); ++i) {
    const geom::SpatialPose X = spatial(names[i]);
    expect_near({X.X.x, X.X.y, X.X.z}, {poses[i].X.x, poses[i].X.y, poses[i].X.z}, 1e-6);
    EXPECT_NEAR(geom::normalize(X.X.a - poses[i].X.a), 0, 1e-6) << names[i];
    EXPECT_NEAR(X.tilt.x, poses[i].tilt.x, 1e-6) << names[i];
    EXPECT_NEAR(X.tilt.y, poses[i].tilt.y, 1e-6) << names[i];
  }
}

TEST_F(TiltTest, a_restart_brings_the_tilts_back) {
  ArenaRun::start(scene_of(kTilted));
  const geom::SpatialPose rig = spatial("rig"), arm = spatial("rig.arm");
  run(1);
  EXPECT_NE(spatial("rig"), rig) << "it falls";
  world::return_to_start(world());
  EXPECT_EQ(spatial("rig"), rig);
  EXPECT_EQ(spatial("rig.arm"), arm);
}

TEST_F(TiltTest, an_arm_turns_about_the_axis_that_its_tilt_gives_it_and_a_slide_runs_along_it) {
  const std::string text = R"(
model( name "stand" pose [0 0 1 0] size [0.1 0.1 0.1] stack_children 0
  actuator( name "elbow" pose [0 0 0 0] tilt [90 0] size [0 0 0] type "rotational" start_position 0.2
            min_position -3 max_position 3 max_speed 0.5 stack_children 0
    model( name "hand" pose [1 0 0 0] size [0.1 0.1 0.1] ) ) )
model( name "post" pose [5 0 1 90] size [0.1 0.1 0.1] stack_children 0
  actuator( name "slide" pose [0 0 0 0] tilt [0 -30] size [0 0 0] type "linear" axis [1 0 0]
            min_position 0 max_position 3 max_speed 1 ) )
)";
  ArenaRun::start(scene_of(text));
  const auto expect_hand = [&](double angle) {
    expect_near(point("stand.elbow.hand", {}), {std::cos(angle), 0, 1 + std::sin(angle)}, 1e-9);
  };
  expect_hand(0.2);
  const auto joint = [&](const char* name) {
    return world::ActuatorRow(world().models.part[world().find(name)]);
  };
  const world::ActuatorRow elbow = joint("stand.elbow"), slide = joint("post.slide");
  for (const char* name : {"stand.elbow", "post.slide"}) world::subscribe(world(), world().find(name));
  ASSERT_TRUE(world::command_joint_position(world(), elbow, 1.2));
  ASSERT_TRUE(world::command_joint_position(world(), slide, 2));
  run(1);
  expect_hand(world().actuators.position[elbow]);
  run(3);
  const double angle = world().actuators.position[elbow], way = world().actuators.position[slide];
  EXPECT_NEAR(angle, 1.2, 0.1);
  EXPECT_NEAR(way, 2, 0.1);
  const geom::Vec3 hand{std::cos(angle), 0, 1 + std::sin(angle)};
  const geom::Vec3 slid{5, way * std::cos(geom::radians(30)), 1 + way * std::sin(geom::radians(30))};
  expect_near(point("stand.elbow.hand", {}), hand);
  expect_near(point("post.slide", {}), slid);
  // A world file has the joint as it was, and its position.
  const Result<std::string> again = scene::write_world(world::as_scene(world()), "w.world");
  ASSERT_TRUE(again) << again.error().line();
  ArenaRun::start(scene_of(*again));
  expect_near(point("stand.elbow.hand", {}), hand, 1e-6);
  expect_near(point("post.slide", {}), slid, 1e-6);
}

TEST_F(TiltTest, an_arm_whose_axis_is_turned_over_turns_the_other_way_and_keeps_its_joint) {
  ArenaRun::start(scene_of(R"(
model( name "stand" pose [0 0 1 0] size [0.1 0.1 0.1] stack_children 0
  actuator( name "elbow" pose [0 0 0 0] tilt [90 0] size [0 0 0] type "rotational" axis [0 0 -1]
            start_position 0.2 min_position -3 max_position 3 max_speed 0.5 stack_children 0
    model( name "hand" pose [1 0 0 0] size [0.1 0.1 0.1] ) ) )
)"));
  const world::ActuatorRow elbow = world().models.part[world().find("stand.elbow")];
  world::subscribe(world(), world().find("stand.elbow"));
  ASSERT_TRUE(world::command_joint_position(world(), elbow, 1));
  for (int second = 0; second < 5; ++second) {
    const double angle = world().actuators.position[elbow];
    expect_near(point("stand.elbow.hand", {}), {std::cos(angle), 0, 1 - std::sin(angle)});
    run(1);
  }
  EXPECT_GT(world().actuators.position[elbow], 0.9);
}

TEST_F(TiltTest, a_joint_that_is_turned_in_place_is_so_for_physics_in_every_tick_and_after_loading) {
  const char* arm = R"(
model( name "stand" pose [0 0 1 0] size [0.1 0.1 0.1] stack_children 0
  actuator( name "elbow" pose [0 0 0 0] size [1 0.1 0.1] type "rotational" start_position 0.5
            min_position -3 max_position 3 ) )
)";
  ArenaRun::start(scene_of(arm));
  const world::ModelRow elbow = world().find("stand.elbow");
  geom::SpatialPose X = world::pose_in_parent(world().models, elbow);
  X.tilt = {0.5 * geom::kPi, 0};
  ASSERT_TRUE(world::set_spatial_pose(world(), elbow, X));
  std::vector<std::byte> saved;
  ASSERT_TRUE(world::save_state(world(), saved));
  run(0.5);
  const std::uint64_t hash = world().hash();
  const world::PhysicsShapes shapes = engine_->physics_shapes();
  ArenaRun::start(scene_of(arm));
  ASSERT_TRUE(world::load_state(world(), saved));
  run(0.5);
  EXPECT_EQ(world().hash(), hash);
  EXPECT_EQ(engine_->physics_shapes().bodies.size(), shapes.bodies.size());
}

TEST_F(TiltTest, odometry_begins_where_a_tilt_puts_a_robot_as_after_a_restart) {
  ArenaRun::start(scene_of(R"(
define base position( localization "odom" size [0.4 0.4 0.2] )
base( name "tilted" pose [0 0 1 30] tilt [30 40] )
model( name "ramp" pose [5 0 1 0] size [1 1 0.1] tilt [0 20] base( name "carried" pose [2 0 0 0] ) )
)"));
  const std::uint64_t hash = world().hash();
  world::return_to_start(world());
  EXPECT_EQ(world().hash(), hash);
  const world::PositionRow robot = world().models.part[world().find("tilted")];
  EXPECT_EQ(world().positions.X_OM[robot], geom::Pose{});
}

TEST_F(TiltTest, the_stage_engine_keeps_all_upright_and_the_words) {
  const scene::SceneDesc scene = scene_of(kTilted);
  auto engine = stage::make_engine(scene, {});
  ASSERT_TRUE(engine);
  const world::World& flat = (*engine)->world();
  EXPECT_EQ(flat.models.tilt_WM[flat.find("plank")], geom::Tilt{});
  EXPECT_DOUBLE_EQ(flat.models.X_WM[flat.find("plank")].a, kYaw);
  const scene::SceneDesc standing = world::as_scene(flat);
  EXPECT_NEAR(standing.models[0].pitch, kPitch, 1e-12);
}

}  // namespace
}  // namespace playhouse::arena
