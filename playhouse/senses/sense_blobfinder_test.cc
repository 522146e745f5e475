// Which patches of a colour a blobfinder sees, and that they are those that Stage saw.

#include <gtest/gtest.h>

#include "playhouse/base/testing/reference.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/stage/engine.h"
#include "playhouse/stage/testing_scenes.h"

namespace playhouse::senses {
namespace {

using stage::testing::box;

const scene::Color kRed{1, 0, 0, 1}, kBlue{0, 0, 1, 1};

/// A camera of 81 columns at the origin, half a metre up, that looks along +x: a column is 1 degree.
scene::SceneDesc lookout(std::vector<scene::Color> colors = {}) {
  scene::SceneDesc scene;
  scene::ModelDesc& model = scene.models.emplace_back();
  model.name = model.alias = "camera";
  model.kind = scene::ModelKind::kBlobfinder;
  model.X_PM = {0, 0, 0.5, 0};
  model.alwayson = true;
  model.blobfinder.emplace();
  model.blobfinder->width = 81;
  model.blobfinder->fov = geom::radians(80);
  model.blobfinder->colors = std::move(colors);
  return scene;
}

/// A box of half a metre, low or high.
void add(scene::SceneDesc& scene, const scene::Color& color, const geom::Pose& X_WM, double height = 0.2) {
  scene.models.push_back(box("box" + std::to_string(scene.models.size()), X_WM, {0.5, 0.5, height}));
  scene.models.back().color = color;
}

std::vector<world::Blob> seen_in(const scene::SceneDesc& scene, unsigned workers = 1) {
  auto engine = stage::make_engine(scene, {.seed = 1, .workers = workers});
  EXPECT_TRUE(engine.ok());
  (*engine)->step();
  EXPECT_EQ((*engine)->world().blobfinders.measured_tick[{0}], 1u);
  return (*engine)->world().blobfinders.blobs[{0}];
}

TEST(BlobfinderSense, sees_patches_from_right_to_left_whatever_their_height) {
  scene::SceneDesc scene = lookout();
  add(scene, kRed, {2.25, 1, 0, 0});
  add(scene, kBlue, {2.25, -1, 0, 0}, 3);
  const std::vector<world::Blob> blobs = seen_in(scene);
  ASSERT_EQ(blobs.size(), 2u);
  EXPECT_EQ(blobs[0].color, kBlue);
  EXPECT_EQ(blobs[1].color, kRed);
  // The nearer face is 2 m ahead, from 0.75 to 1.25 m aside: 20.6 to 32 degrees; its side reaches 16.7.
  EXPECT_EQ(blobs[1].right, 40u - 17);
  EXPECT_EQ(blobs[1].left, 40u - 32);
  EXPECT_EQ(blobs[0].left + blobs[1].right, 80u);
  EXPECT_NEAR(blobs[1].range, 2.3, 0.1);
}

TEST(BlobfinderSense, takes_neighbours_of_one_color_for_one_patch_and_what_stands_before_another_for_itself) {
  scene::SceneDesc scene = lookout();
  add(scene, kRed, {3, 0.25, 0, 0});
  add(scene, kRed, {3, -0.25, 0, 0});
  EXPECT_EQ(seen_in(scene).size(), 1u);
  scene.models.push_back(box("post", {1.5, 0, 0, 0}, {0.05, 0.05, 1}));
  scene.models.back().color = kBlue;
  const std::vector<world::Blob> blobs = seen_in(scene);
  ASSERT_EQ(blobs.size(), 3u);
  EXPECT_EQ(blobs[1].color, kBlue);
  EXPECT_EQ(blobs[0].left, blobs[1].right + 1);
}

TEST(BlobfinderSense, reports_only_the_colors_that_it_looks_for_each_with_its_channel) {
  scene::SceneDesc scene = lookout({kBlue, kRed});
  add(scene, kRed, {2, 1, 0, 0});
  add(scene, {0, 1, 0, 1}, {2, 0, 0, 0});
  add(scene, kBlue, {2, -1, 0, 0});
  std::vector<world::Blob> blobs = seen_in(scene);
  ASSERT_EQ(blobs.size(), 2u);
  EXPECT_EQ(blobs[0].channel, 0u);
  EXPECT_EQ(blobs[1].channel, 1u);
  scene.models[0].blobfinder->colors_count = 1;
  EXPECT_EQ(seen_in(scene).size(), 1u);
}

TEST(BlobfinderSense, looks_where_it_is_turned_and_no_farther_than_its_range) {
  scene::SceneDesc scene = lookout();
  add(scene, kRed, {0, 3, 0, 0});
  EXPECT_TRUE(seen_in(scene).empty());
  scene.models[0].blobfinder->pan = geom::radians(90);
  EXPECT_EQ(seen_in(scene).size(), 1u);
  scene.models[0].blobfinder->range = 2.7;
  EXPECT_TRUE(seen_in(scene).empty());
}

TEST(BlobfinderSense, sees_the_same_with_any_number_of_workers) {
  scene::SceneDesc scene = lookout();
  for (int k = -5; k <= 5; ++k) add(scene, k % 2 ? kRed : kBlue, {4, k * 0.6, 0, 0.1 * k});
  EXPECT_GT(seen_in(scene).size(), 5u);
  EXPECT_EQ(seen_in(scene, 1), seen_in(scene, 3));
}

// Stage:
// {"rgb":[0,0,1],"l":49,"t":25,"r":57,"b":35,"range":2.887891},{"rgb":[1,0,0],"l":23,"t":25,"r":31,...2.908057}.
// Decided: every column of a patch counts, also the one that Stage leaves out behind each; ranges are exact,
// Stage's are of a grid of 0.02 m, up to a cell and a half off.
TEST(BlobfinderSense, sees_what_stage_saw) {
  const auto scene = scene::load_world((reference() / "stage/traces/blobfinder.world").string());
  ASSERT_TRUE(scene.ok()) << scene.error().line();
  auto engine = stage::make_engine(*scene, {});
  ASSERT_TRUE(engine.ok());
  world::World& world = (*engine)->world();
  for (const world::ModelRow row : world.models.rows()) world::subscribe(world, row);
  (*engine)->step();
  const std::vector<world::Blob>& blobs = world.blobfinders.blobs[{0}];
  ASSERT_EQ(blobs.size(), 2u);
  const double recorded[2][5] = {{49, 57, 25, 35, 2.887891}, {23, 31, 25, 35, 2.908057}};
  EXPECT_EQ(blobs[0].color, kBlue);
  EXPECT_EQ(blobs[1].color, kRed);
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(blobs[k].left, recorded[k][0], 1);
    EXPECT_NEAR(blobs[k].right, recorded[k][1], 1);
    EXPECT_EQ(blobs[k].top, recorded[k][2]);
    EXPECT_EQ(blobs[k].bottom, recorded[k][3]);
    EXPECT_NEAR(blobs[k].range, recorded[k][4], 1.5 * 0.02 + 0.01);
  }
}

}  // namespace
}  // namespace playhouse::senses
