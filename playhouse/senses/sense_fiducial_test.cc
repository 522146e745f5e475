// Which targets a fiducial finder sees. What Stage saw of the same scene is in compat_test.cc.

#include "playhouse/senses/sense_fiducial.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "playhouse/stage/engine.h"
#include "playhouse/stage/testing_scenes.h"

namespace playhouse::senses {
namespace {

using stage::testing::box;

/// A finder at the origin, half a metre up, that looks along +x.
scene::SceneDesc lookout(scene::FiducialDesc finder) {
  scene::SceneDesc scene;
  scene::ModelDesc& model = scene.models.emplace_back();
  model.name = model.alias = "finder";
  model.kind = scene::ModelKind::kFiducial;
  model.X_PM = {0, 0, 0.5, 0};
  model.alwayson = true;
  model.fiducial = finder;
  return scene;
}

void add_target(scene::SceneDesc& scene, std::int32_t id, const geom::Pose& X_WM, double height) {
  scene.models.push_back(box("target" + std::to_string(id), X_WM, {0.2, 0.2, height}));
  scene.models.back().fiducial_return = id;
}

std::vector<std::int32_t> seen_in(const scene::SceneDesc& scene) {
  auto engine = stage::make_engine(scene, {.seed = 1, .workers = 1});
  EXPECT_TRUE(engine.ok());
  (*engine)->step();
  std::vector<std::int32_t> ids;
  for (const world::FiducialHit& hit : (*engine)->world().fiducials.hits[{0}]) ids.push_back(hit.id);
  return ids;
}

scene::FiducialDesc wide_finder() {
  scene::FiducialDesc finder;
  finder.range_max = finder.range_max_id = 5;
  finder.fov = geom::kPi;
  return finder;
}

TEST(FiducialSense, sees_nothing_nearer_than_its_minimum_and_at_or_beyond_its_maximum) {
  scene::FiducialDesc finder = wide_finder();
  finder.range_min = 1.5;
  scene::SceneDesc scene = lookout(finder);
  add_target(scene, 1, {1, -1, 0, 0}, 1);   // 1.41 m
  add_target(scene, 2, {1.5, 0, 0, 0}, 1);  // the minimum itself
  add_target(scene, 3, {3, 3, 0, 0}, 1);    // 4.24 m
  add_target(scene, 4, {4, -3, 0, 0}, 1);   // the maximum itself
  add_target(scene, 5, {-2, 0, 0, 0}, 1);   // behind
  EXPECT_EQ(seen_in(scene), (std::vector<std::int32_t>{2, 3}));
}

TEST(FiducialSense, sees_targets_of_any_height_only_if_it_ignores_heights) {
  scene::FiducialDesc finder = wide_finder();
  for (const bool ignores : {false, true}) {
    finder.ignore_zloc = ignores;
    scene::SceneDesc scene = lookout(finder);
    add_target(scene, 1, {2, 0, 0, 0}, 1);
    add_target(scene, 2, {2, 1, 0, 0}, 0.3);     // below the finder
    add_target(scene, 3, {2, -1, 0.7, 0}, 0.3);  // above it
    EXPECT_EQ(seen_in(scene),
              ignores ? (std::vector<std::int32_t>{1, 2, 3}) : (std::vector<std::int32_t>{1}));
  }
}

TEST(FiducialSense, does_not_see_through_what_stands_between_also_if_it_ignores_heights) {
  scene::FiducialDesc finder = wide_finder();
  finder.ignore_zloc = true;
  scene::SceneDesc scene = lookout(finder);
  add_target(scene, 1, {3, 0, 0, 0}, 0.3);
  add_target(scene, 2, {3, 2, 0, 0}, 0.3);
  scene.models.push_back(box("wall", {1, 0, 0, 0}, {0.1, 0.5, 1}));
  scene.models.push_back(box("step", {1.5, 1, 0, 0}, {0.1, 0.5, 0.4}));  // the line of sight passes above it
  EXPECT_EQ(seen_in(scene), (std::vector<std::int32_t>{2}));
}

// The upper end of the target is at the height of the finder, to the bit or a rounding away from it.
TEST(FiducialSense, sees_bodies_as_high_as_it_is_wherever_they_were_before) {
  scene::SceneDesc scene;
  scene.models.push_back(stage::testing::robot("a", {0, 0, 0, 0}, {0.2, 0.2, 0.3}));
  scene.models.push_back(lookout(wide_finder()).models[0]);
  scene.models[1].parent = 0;
  scene.models[1].X_PM = {0, 0, 0.3, 0};
  scene.models.push_back(stage::testing::robot("b", {2, 0, 0, 0}, {0.2, 0.2, 0.3}));
  scene.models[2].fiducial_return = 7;
  auto engine = stage::make_engine(scene, {.seed = 1, .workers = 1});
  ASSERT_TRUE(engine.ok());
  world::World& world = (*engine)->world();
  for (int i = 1; i < 100; ++i) {
    for (const world::ModelRow robot : {world::ModelRow{0}, world::ModelRow{2}}) {
      geom::Pose at = world.models.X_WM[robot];
      at.z = i / 7.0;
      ASSERT_TRUE(world::set_pose(world, robot, at));
    }
    (*engine)->step();
    EXPECT_EQ(world.fiducials.hits[{0}].size(), 1u) << i;
  }
}

}  // namespace
}  // namespace playhouse::senses
