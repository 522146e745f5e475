#include "playhouse/scene/mesh_bodies.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/mesh/testing_meshes.h"
#include "playhouse/scene/testing_same_scene.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/scene/write_world.h"

namespace playhouse::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Loaded {
  Result<SceneDesc> scene;
  std::vector<Error> others;
};

Loaded load(const std::string& text, std::map<std::string, std::string> more = {}) {
  more.try_emplace("w/box.dae", mesh::test_collada());
  MemoryFiles files(std::move(more));
  std::vector<Error> others;
  Result<SceneDesc> scene = load_world_text(text, "w/a.world", files, {}, &others);
  return {std::move(scene), std::move(others)};
}

SceneDesc scene_of(const std::string& text) {
  const Loaded loaded = load(text);
  EXPECT_TRUE(loaded.scene) << (loaded.scene ? "" : loaded.scene.error().line());
  return loaded.scene ? *loaded.scene : SceneDesc();
}

TEST(MeshWord, a_model_is_as_large_as_its_mesh_and_stands_on_its_floor) {
  const SceneDesc scene = scene_of("model( mesh \"box.dae\" )");
  const ModelDesc& model = scene.models.at(0);
  ASSERT_TRUE(model.mesh);
  EXPECT_NEAR(model.size.x, 2, 1e-6);
  EXPECT_NEAR(model.size.y, 1, 1e-6);
  EXPECT_NEAR(model.size.z, 0.5, 1e-6);
  EXPECT_NEAR(model.mesh->low.z, 0, 1e-6);
  ASSERT_EQ(model.blocks.size(), 1u);
  EXPECT_THAT(model.blocks[0].points, ElementsAre(geom::Vec2{-1, -0.5}, geom::Vec2{1, -0.5},
                                                  geom::Vec2{1, 0.5}, geom::Vec2{-1, 0.5}));
  EXPECT_NEAR(model.blocks[0].z_max, 0.5, 1e-6);
}

TEST(MeshWord, a_size_stretches_it) {
  const SceneDesc scene = scene_of("model( mesh \"box.dae\" size [4 4 4] )");
  const ModelDesc& model = scene.models.at(0);
  EXPECT_EQ(model.size, (geom::Size{4, 4, 4}));
  EXPECT_NEAR(model.mesh->high.x, 2, 1e-6);
  EXPECT_NEAR(model.mesh->high.z, 4, 1e-6);
}

TEST(MeshWord, a_file_is_read_once_and_models_of_one_size_share_it) {
  const SceneDesc scene = scene_of(
      "model( mesh \"box.dae\" mass 1 ) model( mesh \"box.dae\" mass 2 ) model( mesh \"box.dae\" size [1 1 "
      "1] )");
  ASSERT_EQ(scene.models.size(), 3u);
  EXPECT_EQ(scene.models[0].mesh, scene.models[1].mesh);
  EXPECT_NE(scene.models[0].mesh, scene.models[2].mesh);
}

TEST(MeshWord, is_written_back) {
  const SceneDesc scene = scene_of(
      "define box model( mesh \"box.dae\" ) box( pose [1 2 0 30] ) box( size [1 2 3] ) position( mesh "
      "\"box.dae\" )");
  const Result<std::string> text = write_world(scene, "w/b.world");
  ASSERT_TRUE(text) << text.error().line();
  EXPECT_THAT(*text, HasSubstr("mesh \"box.dae\""));
  EXPECT_EQ(difference(scene, scene_of(*text)), "");
}

TEST(MeshWord, tells_file_and_line_of_what_is_wrong) {
  const auto error = [](const std::string& text, std::map<std::string, std::string> files = {}) {
    const Loaded loaded = load(text, std::move(files));
    return loaded.scene ? "loaded" : loaded.scene.error().line();
  };
  EXPECT_THAT(
      error("\nmodel( mesh \"bax.dae\" )"),
      HasSubstr(
          "w/a.world:2: mesh \"w/bax.dae\" cannot be opened: no such file (did you mean \"box.dae\"?)"));
  EXPECT_THAT(error("model( mesh \"a.dae\" )", {{"w/a.dae", "<x/>"}}),
              HasSubstr("w/a.world:1: mesh \"w/a.dae\" cannot be read: "));
  EXPECT_THAT(error("model( mesh \"a.png\" )", {{"w/a.png", mesh::test_png()}}),
              HasSubstr("mesh \"w/a.png\" is no mesh"));
  EXPECT_THAT(error("gripper( mesh \"box.dae\" )"), HasSubstr("a gripper has paddles and no mesh"));
}

TEST(MeshWord, warns_of_words_that_have_no_effect_beside_it) {
  const SceneDesc scene = scene_of("model( mesh \"box.dae\" boundary 1 )");
  EXPECT_THAT(scene.warnings, testing::Contains(HasSubstr("a mesh is all of a body")));
}

TEST(MeshOutlines, are_those_of_parts) {
  const std::string obj = mesh::test_obj();
  std::string two = obj;  // the same box again, five metres ahead
  for (int k = 0; k < 8; ++k) {
    double p[3];
    for (int i = 0; i < 3; ++i) p[i] = (k >> i & 1) != 0 ? mesh::kTestHalf[i] : -mesh::kTestHalf[i];
    two += fmt::format("v {} {} {}\n", p[0] + 5, p[2] + 1, -p[1]);
  }
  for (const auto& quad : mesh::kTestQuads)
    two += fmt::format("f {} {} {} {}\n", quad[0] + 9, quad[1] + 9, quad[2] + 9, quad[3] + 9);
  const Loaded loaded = load("model( mesh \"two.obj\" )", {{"w/two.obj", two}});
  ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
  const std::vector<Block>& blocks = loaded.scene->models.at(0).blocks;
  ASSERT_EQ(blocks.size(), 2u);
  EXPECT_NEAR(blocks[0].z_min, 0, 1e-6);
  EXPECT_NEAR(blocks[1].z_min, 1, 1e-6);
  EXPECT_NEAR(blocks[1].z_max, 1.5, 1e-6);
}

}  // namespace
}  // namespace playhouse::scene
