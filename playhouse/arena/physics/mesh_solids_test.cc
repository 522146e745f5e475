// Meshes in the arena: what carries, what is pushed, what rays meet.

#include "playhouse/arena/physics/mesh_solids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "playhouse/arena/physics/round_solids.h"
#include "playhouse/arena/physics/testing_trials.h"
#include "playhouse/arena/surface.h"
#include "playhouse/arena/testing_runs.h"
#include "playhouse/mesh/testing_meshes.h"

namespace playhouse::arena {
namespace {

double length_of(const Vec3& v) {
  return std::sqrt(dot(v, v));
}

std::string file(const std::string& name) {
  std::ifstream in(PLAYHOUSE_SOURCE_DIR "/worlds/meshes/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A loose body of 2 kg with a round shape along y about (0, 0, 0.1), seen as two triangles.
std::string round_file(const std::string& shape) {
  return R"(<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="12">
-0.1 -0.1 0 0.1 0.1 0 -0.1 0.1 0.2 0.1 -0.1 0.2</float_array><technique_common>
<accessor source="#a" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="2"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2 0 1 3</p></triangles>
</mesh></geometry></library_geometries>
<library_physics_models><physics_model id="m"><rigid_body sid="b"><technique_common><dynamic>true</dynamic>
<mass>2</mass><shape><translate>0 0 0.1</translate>)" +
         shape + R"(</shape></technique_common></rigid_body></physics_model></library_physics_models>
<library_physics_scenes><physics_scene id="s"><instance_physics_model url="#m">
<instance_rigid_body body="b" target="#n"/></instance_physics_model></physics_scene></library_physics_scenes>
<library_visual_scenes><visual_scene id="f"><node id="n"><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_physics_scene url="#s"/><instance_visual_scene url="#f"/></scene>
</COLLADA>)";
}

class MeshTest : public ArenaRun {
 protected:
  void start(const std::string& text) {
    std::map<std::string, std::string> files{{"box.obj", mesh::test_obj()}};
    for (const char* name : {"ramp.dae", "barrel.dae", "table.dae", "planks.png"}) files[name] = file(name);
    files["ball.dae"] = round_file("<sphere><radius>0.1</radius></sphere>");
    files["log.dae"] = round_file("<capsule><radius>0.1 0.1</radius><height>0.2</height></capsule>");
    files["drum.dae"] = round_file("<cylinder><radius>0.1 0.1</radius><height>0.4</height></cylinder>");
    config::MemoryFiles memory(files);
    Result<scene::SceneDesc> scene = scene::load_world_text("interval_sim 100\n" + text, "w.world", memory);
    ASSERT_TRUE(scene) << scene.error().line();
    ArenaRun::start(std::move(*scene));
  }
  world::ModelRow row(const char* name) { return world().find(name); }
};

constexpr const char* kRover =
    "position( name \"rover\" drive \"omni\" pose [-2.5 0 0 0] size [0.4 0.3 0.25] localization \"odom\" "
    "odom_error [0 0 0 "
    "0] )\n";

TEST_F(MeshTest, robots_drive_up_the_triangles_of_what_stands_still) {
  start(std::string(kRover) + "model( name \"ramp\" mesh \"ramp.dae\" )");
  drive("rover", {0.5, 0, 0, 0});
  run(5);
  EXPECT_NEAR(pose("rover").x, 0, 0.15);
  EXPECT_NEAR(pose("rover").z, 0.25, 0.01);
  run(5);
  EXPECT_GT(pose("rover").x, 1.8);
  EXPECT_NEAR(pose("rover").z, 0, 0.01);
}

TEST_F(MeshTest, rays_meet_the_triangles_and_not_the_outline) {
  start(
      "model( name \"ramp\" mesh \"ramp.dae\" )\n"
      "position( name \"low\" pose [-3 0 0 0] size [0.2 0.2 0.05] ranger( pose [0 0 0.05 0] size [0 0 0]\n"
      "  sensor( size [0 0 0] samples 1 range [0 8] ) ) )");
  world::subscribe(world(), world().rangers.model[{0}]);
  run(0.2);
  const double z = world().models.X_WM[world().rangers.model[{0}]].z;
  // The slope rises by a quarter, from x = -1.2.
  EXPECT_NEAR(world().sensors.ranges[{0}], 3 - 1.2 + 4 * z, 2e-3);
  EXPECT_GT(z, 0.05);
}

TEST_F(MeshTest, rays_go_under_a_table_that_moves) {
  start(
      "model( name \"table\" mesh \"table.dae\" pose [2 0 0 0] )\n"
      "model( name \"wall\" pose [5 0 0 0] size [0.1 4 2] )\n"
      "position( name \"low\" size [0.2 0.2 0.3] ranger( size [0 0 0] sensor( samples 1 range [0 8] ) ) )");
  world::subscribe(world(), world().rangers.model[{0}]);
  run(0.2);
  EXPECT_NEAR(world().sensors.ranges[{0}], 4.95, 2e-3);
}

TEST_F(MeshTest, what_a_file_calls_dynamic_falls_and_is_pushed) {
  start(std::string(kRover) + "model( name \"barrel\" mesh \"barrel.dae\" pose [-1 0 0.3 0] )");
  EXPECT_EQ(world().models.mobility[row("barrel")], world::Mobility::kLoose);
  run(2);
  EXPECT_NEAR(pose("barrel").z, 0, 3e-3);
  const double x = pose("barrel").x;
  drive("rover", {0.4, 0, 0, 0});
  run(5);
  EXPECT_GT(pose("barrel").x, x + 0.3);
}

TEST_F(MeshTest, two_barrels_stack_and_a_box_lies_on_a_table) {
  start(
      "model( name \"low\" mesh \"barrel.dae\" )\nmodel( name \"high\" mesh \"barrel.dae\" pose [0 0 0.82 0] "
      ")\n"
      "model( name \"table\" mesh \"table.dae\" pose [3 0 0 0] )\n"
      "model( name \"box\" pose [3 0 0.8 0] size [0.2 0.2 0.2] gripper_return 1 )");
  run(3);
  EXPECT_NEAR(pose("high").z, 0.8, 0.01);
  EXPECT_NEAR(pose("box").z, 0.74, 0.01);
}

TEST_F(MeshTest, the_file_says_how_it_rubs_where_the_world_does_not) {
  start(
      "model( mesh \"barrel.dae\" ) model( mesh \"barrel.dae\" friction 0.9 ) model( mesh \"barrel.dae\" "
      "material \"ice\" )");
  EXPECT_EQ(surface_of(scene_->models.at(0)), (ContactSurface{0.5, 0.2}));
  EXPECT_EQ(surface_of(scene_->models.at(1)), (ContactSurface{0.9, 0.2}));
  EXPECT_LT(surface_of(scene_->models.at(2)).friction, 0.1);
}

/// The slope rises by a quarter, from x = -1.2 to -0.2: g sin / (1 + I / (m r^2)) from rest.
TEST_F(MeshTest, balls_and_drums_roll_down_a_ramp_at_the_rate_of_their_inertia) {
  start(
      "model( name \"ramp\" mesh \"ramp.dae\" )\n"
      "model( name \"ball\" mesh \"ball.dae\" pose [-0.3 0.4 0.2281 0] )\n"
      "model( name \"drum\" mesh \"drum.dae\" pose [-0.3 -0.2 0.2281 0] )\n");
  run(0.5);
  const double slides = 9.81 * 0.25 / std::sqrt(1.0625);
  const auto speed = [&](const char* name) {
    const geom::SpatialVelocity& V = world().models.V_WM[row(name)];
    const geom::Quaternion q =
        geom::orientation(world().models.X_PM[row(name)].a, world().models.tilt_PM[row(name)]);
    return length_of(V.v + cross(V.w, q * Vec3{0, 0, 0.1}));  // of the centre
  };
  EXPECT_NEAR(speed("ball"), 0.5 * slides * 5 / 7, 0.01);
  EXPECT_NEAR(speed("drum"), 0.5 * slides * 2 / 3, 0.01);
}

TEST_F(MeshTest, what_rolls_is_the_same_run_for_any_number_of_workers_and_from_any_saved_tick) {
  start(
      "model( name \"ramp\" mesh \"ramp.dae\" )\n"
      "model( mesh \"ball.dae\" pose [-0.3 0.4 0.3 0] ) model( mesh \"drum.dae\" pose [-0.3 -0.2 0.3 0] )\n"
      "model( mesh \"log.dae\" pose [0.3 0 0.4 40] ) model( mesh \"drum.dae\" pose [-0.25 0 0.6 20] )\n"
      "model( pose [-2 0 0 0] size [0.3 0.3 0.3] gripper_return 1 )");
  expect_the_same_run(
      30, 7, [](world::World&, int) {}, [](world::World&) {});
}

TEST_F(MeshTest, is_the_same_run_for_any_number_of_workers_and_from_any_saved_tick) {
  start(std::string(kRover) +
        "model( name \"ramp\" mesh \"ramp.dae\" )\nmodel( name \"barrel\" mesh \"barrel.dae\" pose [0.3 0 "
        "0.5 0] )\n"
        "model( name \"table\" mesh \"table.dae\" pose [0.1 0 1.5 0] )");
  expect_the_same_run(
      50, 7,
      [&](world::World&, int tick) {
        if (tick == 0) drive("rover", {0.5, 0, 0, 0});
      },
      [](world::World& world) { world::subscribe(world, world.find("rover")); });
}

TEST(HullContent, is_that_of_a_box_wherever_it_is) {
  Hull box;
  for (const double x : {1.0, 3.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {5.0, 5.5}) box.push_back({x, y, z});
  const HullContent content = hull_content(box);
  EXPECT_NEAR(content.volume, 2, 1e-9);
  EXPECT_NEAR(content.center.x, 2, 1e-9);
  EXPECT_NEAR(content.center.y, 0, 1e-9);
  EXPECT_NEAR(content.center.z, 5.25, 1e-9);
}

TEST(MeshHulls, of_round_shapes_hold_nearly_as_much_as_they) {
  mesh::Mesh of;
  of.physics.emplace();
  of.physics->shapes.push_back({mesh::ShapeKind::kSphere, {}, {}, {1, 1, 1}, {}, {}});
  of.physics->shapes.push_back({mesh::ShapeKind::kCylinder, {}, {}, {1, 1, 1}, {}, {}});
  of.physics->shapes.push_back({mesh::ShapeKind::kCapsule, {}, {}, {1, 1, 1}, {}, {}});
  MeshHulls hulls;
  ASSERT_EQ(hulls.of(of).size(), 3u);
  const double ball = 4.0 / 3 * geom::kPi, tube = 2 * geom::kPi;
  const double expected[] = {ball, tube, ball + tube};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GT(hull_content(hulls.of(of)[i]).volume, 0.95 * expected[i]);
    EXPECT_LT(hull_content(hulls.of(of)[i]).volume, expected[i]);
  }
  EXPECT_EQ(hulls.of(of)[0].round, Round::kSphere);
  EXPECT_EQ(hulls.of(of)[1].round, Round::kCylinder);
  EXPECT_EQ(hulls.of(of)[2].round, Round::kCapsule);
}

mesh::Mesh with_shapes(std::initializer_list<mesh::CollisionShape> shapes) {
  mesh::Mesh mesh;
  mesh.physics.emplace();
  for (const mesh::CollisionShape& shape : shapes) mesh.physics->shapes.push_back(shape);
  return mesh;
}

TEST(FixedParts, without_thickness_are_flat_or_left_out) {
  using mesh::ShapeKind;
  const FixedParts parts = fixed_parts(with_shapes({{ShapeKind::kCylinder, {}, {}, {1, 1, 0}, {}, {}},
                                                    {ShapeKind::kCapsule, {}, {}, {1, 1, 0}, {}, {}},
                                                    {ShapeKind::kCylinder, {}, {}, {0, 0, 1}, {}, {}},
                                                    {ShapeKind::kCapsule, {}, {}, {0, 0, 1}, {}, {}},
                                                    {ShapeKind::kSphere, {}, {}, {0, 0, 0}, {}, {}},
                                                    {ShapeKind::kBox, {}, {}, {0, 1, 0}, {}, {}}}),
                                       {});
  ASSERT_EQ(parts.hulls.size(), 2u) << "the disc and the ball";
  EXPECT_EQ(parts.hulls[0].round, Round::kNot);
  EXPECT_EQ(parts.hulls[1].round, Round::kSphere);
}

TEST(FixedParts, that_are_discs_of_no_height_carry_what_is_round) {
  const FixedParts parts =
      fixed_parts(with_shapes({{mesh::ShapeKind::kCylinder, {0, 0, 0.5}, {}, {2, 2, 0}, {}, {}}}), {});
  ASSERT_EQ(parts.hulls.size(), 1u);
  FixedSolid disc;
  disc.hull = parts.hulls[0];
  for (const double tick : {0.001, 0.01, 0.05}) {
    Trial trial(tick);
    trial.physics.set_fixed(std::vector<FixedSolid>{disc});
    const auto drop = [&](const Hull& hull, const Vec3& p) {
      return trial.add({.hulls = {hull}, .mass = 2, .center = {}, .surface = {}, .wheels = {}}, {.p = p});
    };
    const RigidBodyRow ball = drop(round_hull(0.1, 0), {0.5, 0.3, 0.7}),
                       drum = drop(cylinder_hull(0.3, 0.4), {-0.7, 0, 0.95});
    trial.run(2);
    EXPECT_NEAR(trial.physics.state(ball).p.z, 0.6, 0.004);
    EXPECT_NEAR(trial.physics.state(drum).p.z, 0.9, 0.004);
  }
}

}  // namespace
}  // namespace playhouse::arena
