#include "playhouse/bodies/enclosure.h"

#include <gtest/gtest.h>

#include "playhouse/bodies/space.h"
#include "playhouse/stage/engine.h"
#include "playhouse/stage/testing_scenes.h"

namespace playhouse::bodies {
namespace {

constexpr geom::Size kBody{1, 0.8, 0.2};

scene::ModelDesc part(const std::string& name, const Pose& X_PM, const geom::Size& size) {
  scene::ModelDesc model = stage::testing::box(name, X_PM, size);
  model.parent = 0;
  return model;
}

/// What is enclosed of a part of a robot of kBody.  [m]
double enclosed(scene::ModelDesc body, std::vector<scene::ModelDesc> others) {
  scene::SceneDesc scene;
  scene.models.push_back(std::move(body));
  for (scene::ModelDesc& other : others) scene.models.push_back(std::move(other));
  world::World world(scene, 1);
  Shapes shapes(world.scene());
  Trees trees = make_trees(world);
  Solids solids = make_fixed_solids(world, shapes);
  replace_moving_solids(solids, world, shapes, trees);
  return solids.enclosed.back();
}

double enclosed(const scene::ModelDesc& part) {
  return enclosed(stage::testing::robot("r", {5, 6, 0, 0.7}, kBody), {part});
}

TEST(Enclosure, is_what_is_within_the_body_up_to_its_top) {
  EXPECT_EQ(enclosed(part("p", {0.1, 0, 0.05, 0.4}, {0.2, 0.2, 0.1})), Solids::kAll);
  EXPECT_EQ(enclosed(part("p", {0.1, 0, 0, 0}, {0.2, 0.2, 0.2})), Solids::kAll) << "as high as the body";
  EXPECT_DOUBLE_EQ(enclosed(part("p", {0.1, 0, 0.05, 0}, {0.2, 0.2, 0.2})), 0.15) << "it looks out above";
}

TEST(Enclosure, is_nothing_of_what_looks_out_at_a_side_or_below) {
  EXPECT_EQ(enclosed(part("p", {0.45, 0, 0.05, 0}, {0.2, 0.2, 0.1})), 0);
  EXPECT_EQ(enclosed(part("p", {0.4, 0, 0.05, 0}, {0.2, 0.2, 0.1})), 0) << "its side is that of the body";
  EXPECT_EQ(enclosed(part("p", {0.38, 0.28, 0.05, 0.7}, {0.2, 0.2, 0.1})), 0) << "one corner";
  EXPECT_EQ(enclosed(part("p", {0, 0, -0.05, 0}, {0.2, 0.2, 0.1})), 0);
  EXPECT_EQ(enclosed(part("p", {0, 0, 0.2, 0}, {0.2, 0.2, 0.1})), 0) << "on top";
  EXPECT_EQ(enclosed(part("p", {0, 0, 0.05, 0}, {1.2, 1.0, 0.1})), 0) << "larger than the body";
}

TEST(Enclosure, goes_through_parts_and_stops_at_what_moves_by_itself) {
  scene::ModelDesc of_part = part("q", {-0.1, 0, 0.05, 0}, {0.1, 0.1, 0.05});
  of_part.parent = 1;
  EXPECT_EQ(enclosed(stage::testing::robot("r", {}, kBody),
                     {part("p", {0.45, 0, 0.05, 0}, {0.2, 0.2, 0.1}), of_part}),
            Solids::kAll);
  of_part.X_PM.x = 0;
  EXPECT_EQ(enclosed(stage::testing::robot("r", {}, kBody),
                     {part("p", {0.45, 0, 0.05, 0}, {0.08, 0.08, 0.1}), of_part}),
            0)
      << "in no other";
  scene::ModelDesc slide = stage::testing::actuator("p", {0.1, 0, 0.05, 0}, {0.2, 0.2, 0.1});
  slide.parent = 0;
  EXPECT_EQ(enclosed(slide), 0);
}

TEST(Enclosure, takes_a_body_that_all_see_and_that_is_convex) {
  scene::ModelDesc in = part("p", {0.1, 0, 0.05, 0.4}, {0.2, 0.2, 0.1});
  scene::ModelDesc unseen = stage::testing::robot("r", {}, kBody);
  unseen.ranger_return = -1;
  EXPECT_EQ(enclosed(unseen, {in}), 0);
  in.ranger_return = -1;
  EXPECT_EQ(enclosed(unseen, {in}), Solids::kAll) << "neither is seen by a ranger";

  scene::ModelDesc dart = stage::testing::robot("r", {}, kBody);
  dart.blocks = {{{{-0.5, -0.4}, {0.5, 0}, {-0.5, 0.4}, {-0.4, 0}}, 0, 0.2}};
  EXPECT_EQ(enclosed(dart, {part("p", {0, 0, 0.05, 0}, {0.02, 0.02, 0.1})}), 0);
}

/// The range of a ranger without a body that looks at a robot with one part, both 1 m ahead.
double seen_from(double z, const Pose& X_part) {
  scene::SceneDesc scene;
  scene.models = {stage::testing::robot("r", {2, 0, 0, 0}, kBody), part("p", {}, {0.4, 0.4, 0.3}),
                  stage::testing::ranger("eye", -1, {0, 0, z, 0})};
  scene.models[2].sensors = {stage::testing::sensor({}, 8, 0, 1)};
  auto engine = stage::make_engine(scene, {});
  EXPECT_TRUE(engine);
  world::World& world = (*engine)->world();
  (*engine)->step();
  EXPECT_TRUE(world::set_pose(world, world.find("p"), X_part));
  (*engine)->step();
  return static_cast<double>(world.sensors.ranges[{0}]);
}

TEST(Enclosure, changes_no_range_also_when_a_part_is_put_elsewhere_on_its_robot) {
  EXPECT_NEAR(seen_from(0.1, {}), 1.5, 1e-6) << "the body";
  EXPECT_NEAR(seen_from(0.25, {}), 1.8, 1e-6) << "the part above it";
  EXPECT_NEAR(seen_from(0.1, {-0.7, 0, 0, 0}), 1.1, 1e-6) << "the part before it";
  EXPECT_NEAR(seen_from(0.25, {0.1, 0, 0, 0}), 1.9, 1e-6);
}

}  // namespace
}  // namespace playhouse::bodies
