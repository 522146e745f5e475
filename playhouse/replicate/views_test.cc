// What viewers are told of single kinds beyond their poses.

#include "playhouse/replicate/views.h"

#include <gtest/gtest.h>

namespace playhouse::replicate {
namespace {

/// A world of one model.
scene::SceneDesc scene_of(scene::ModelKind kind) {
  scene::SceneDesc scene;
  scene.models.emplace_back().kind = kind;
  return scene;
}

std::vector<std::int32_t> view_of(const world::World& world) {
  std::vector<std::int32_t> values;
  for (const KindView& view : views())
    if (const world::KindRow row = view.row_of(world, {0})) EXPECT_TRUE(view.capture(world, row, values));
  return values;
}

TEST(KindView, of_a_lamp_tells_whether_it_is_on_and_lit_and_how_it_blinks) {
  scene::SceneDesc scene = scene_of(scene::ModelKind::kBlinkenlight);
  scene.models[0].blinkenlight = {0.5, 0.25, true};
  world::World world(scene, 1);
  const std::uint8_t lit = state_bits(world, {0});
  world.blinkenlights.lit[{0}] = 0;
  const std::uint8_t dark = state_bits(world, {0});
  world.blinkenlights.enabled[{0}] = 0;
  const std::uint8_t off = state_bits(world, {0});
  EXPECT_GT(lit, dark);
  EXPECT_GT(dark, off);
  EXPECT_EQ(off, 0);
  EXPECT_EQ(view_of(world), (std::vector<std::int32_t>{500, 250}));
}

}  // namespace
}  // namespace playhouse::replicate
