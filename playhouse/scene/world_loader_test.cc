#include "playhouse/scene/world_loader.h"

#include <gtest/gtest.h>

namespace playhouse::scene {
namespace {

Result<SceneDesc> load(const std::string& text) {
  MemoryFiles files({});
  return load_world_text(text, "t.world", files);
}

TEST(WorldLoader, a_default_model_is_named_after_its_type_and_stands_as_a_box) {
  const auto scene = load("model( pose [1 2 0 90] size [1 2 3] )");
  ASSERT_TRUE(scene.ok()) << scene.error().line();
  ASSERT_EQ(scene->models.size(), 1u);
  const ModelDesc& model = scene->models[0];
  EXPECT_EQ(model.name, "model:1");
  EXPECT_DOUBLE_EQ(model.X_PM.a, geom::kPi / 2);
  ASSERT_EQ(model.blocks.size(), 1u);
  EXPECT_EQ(model.blocks[0].points[0], (geom::Vec2{-0.5, -1}));
  EXPECT_EQ(model.blocks[0].z_max, 3);
}

}  // namespace
}  // namespace playhouse::scene
