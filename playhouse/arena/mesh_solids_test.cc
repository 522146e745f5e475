// Meshes in the arena: what carries, what is pushed, what rays meet.

#include "playhouse/arena/mesh_solids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "playhouse/arena/surface.h"
#include "playhouse/arena/testing_runs.h"
#include "playhouse/mesh/testing_meshes.h"

namespace playhouse::arena {
namespace {

std::string file(const std::string& name) {
  std::ifstream in(PLAYHOUSE_SOURCE_DIR "/worlds/meshes/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class MeshTest : public ArenaRun {
 protected:
  void start(const std::string& text) {
    std::map<std::string, std::string> files{{"box.obj", mesh::test_obj()}};
    for (const char* name : {"ramp.dae", "barrel.dae", "table.dae", "planks.png"}) files[name] = file(name);
    scene::MemoryFiles memory(files);
    Result<scene::SceneDesc> scene = scene::load_world_text("interval_sim 100\n" + text, "w.world", memory);
    ASSERT_TRUE(scene) << scene.error().line();
    ArenaRun::start(std::move(*scene));
  }
  std::uint32_t row(const char* name) { return world().find(name).index; }
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
  world::subscribe(world(), world().rangers.model[0]);
  run(0.2);
  const double z = world().models.X_WM[world().rangers.model[0].index].z;
  // The slope rises by a quarter, from x = -1.2.
  EXPECT_NEAR(world().sensors.ranges[0], 3 - 1.2 + 4 * z, 2e-3);
  EXPECT_GT(z, 0.05);
}

TEST_F(MeshTest, rays_go_under_a_table_that_moves) {
  start(
      "model( name \"table\" mesh \"table.dae\" pose [2 0 0 0] )\n"
      "model( name \"wall\" pose [5 0 0 0] size [0.1 4 2] )\n"
      "position( name \"low\" size [0.2 0.2 0.3] ranger( size [0 0 0] sensor( samples 1 range [0 8] ) ) )");
  world::subscribe(world(), world().rangers.model[0]);
  run(0.2);
  EXPECT_NEAR(world().sensors.ranges[0], 4.95, 2e-3);
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
  EXPECT_EQ(surface_of(scene_->models.at(0)), (Surface{0.5, 0.2}));
  EXPECT_EQ(surface_of(scene_->models.at(1)), (Surface{0.9, 0.2}));
  EXPECT_LT(surface_of(scene_->models.at(2)).friction, 0.1);
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
}

}  // namespace
}  // namespace playhouse::arena
