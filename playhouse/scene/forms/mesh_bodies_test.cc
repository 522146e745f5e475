#include "playhouse/scene/forms/mesh_bodies.h"

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
  config::MemoryFiles files(std::move(more));
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

// The truth is the box of the same words without "look".
TEST(Look, changes_the_appearance_alone) {
  const char* const kBox = "position( name \"r\" size [0.4 0.3 0.2] origin [0.1 0 0 0] color \"red\" ";
  const SceneDesc plain = scene_of(std::string(kBox) + ")");
  const SceneDesc scene = scene_of(std::string(kBox) + "look \"box.dae\" )");
  const ModelDesc& model = scene.models.at(0);
  ASSERT_TRUE(model.look);
  EXPECT_FALSE(model.mesh);
  EXPECT_EQ(model.blocks, plain.models.at(0).blocks);
  EXPECT_EQ(model.size, plain.models.at(0).size);
  EXPECT_EQ(static_cast<const PlainDesc&>(model), static_cast<const PlainDesc&>(plain.models.at(0)));
  EXPECT_NEAR(model.look->low.x, -0.2, 1e-6);
  EXPECT_NEAR(model.look->high.y, 0.15, 1e-6);
  EXPECT_NEAR(model.look->low.z, 0, 1e-6);
  EXPECT_NEAR(model.look->high.z, 0.2, 1e-6);
}

TEST(Look, is_shared_by_models_of_one_size) {
  const SceneDesc scene = scene_of(
      "model( look \"box.dae\" mass 1 ) model( look \"box.dae\" mass 2 ) model( look \"box.dae\" size [1 1 "
      "2] )");
  EXPECT_EQ(scene.models.at(0).look, scene.models.at(1).look);
  EXPECT_NE(scene.models.at(0).look, scene.models.at(2).look);
}

TEST(Look, is_told_where_it_cannot_be) {
  const Loaded missing = load("model( look \"bux.dae\" )");
  ASSERT_FALSE(missing.scene);
  EXPECT_THAT(missing.scene.error().line(), testing::HasSubstr("look \"w/bux.dae\" cannot be opened"));
  const Loaded paddles = load("position( gripper( look \"box.dae\" ) )");
  ASSERT_FALSE(paddles.scene);
  EXPECT_THAT(paddles.scene.error().line(), testing::HasSubstr("a gripper has paddles and no look"));
  const SceneDesc bare = scene_of("position( ranger( size [0 0 0] look \"box.dae\" ) )");
  EXPECT_THAT(bare.warnings, ElementsAre("w/a.world:1: \"look\" has no effect on a model without a size"));
}

TEST(Look, may_be_all_that_there_is_of_a_sensor) {
  const SceneDesc scene = scene_of("position( ranger( size [0.1 0.1 0.2] look \"box.dae\" ) )");
  ASSERT_TRUE(scene.models.at(1).look);
  EXPECT_NEAR(scene.models.at(1).look->high.z, 0.2, 1e-6);
  EXPECT_TRUE(scene.models.at(1).blocks.empty());
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

geom::Vec3 extent_of(const ModelDesc& model) {
  return model.mesh->high - model.mesh->low;
}

TEST(MeshWord, mesh_pose_turns_a_file_with_other_axes_and_the_size_is_that_of_what_was_turned) {
  // 2 x 1 x 0.5 m, on edge.
  const SceneDesc scene = scene_of(
      "model( mesh \"box.dae\" mesh_pose [0 0 0 -90 0 0] ) model( mesh \"box.dae\" mesh_pose [0 0 0 -90 0 "
      "90] ) "
      "model( mesh \"box.dae\" mesh_pose [0 0 0 90 0 0] size [4 4 4] )");
  EXPECT_EQ(scene.models.at(0).size, (geom::Size{2, 0.5, 1}));
  EXPECT_EQ(scene.models.at(1).size, (geom::Size{0.5, 2, 1}));
  EXPECT_EQ(extent_of(scene.models.at(2)), (geom::Vec3{4, 4, 4}));
  EXPECT_EQ(scene.models.at(0).mesh->low.z, 0) << "on the floor";
  EXPECT_THAT(scene.models.at(1).blocks.at(0).points, ElementsAre(geom::Vec2{-0.25, -1}, geom::Vec2{0.25, -1},
                                                                  geom::Vec2{0.25, 1}, geom::Vec2{-0.25, 1}));
  EXPECT_THAT(scene.warnings, testing::IsEmpty());
}

TEST(MeshWord, a_mesh_that_is_not_fitted_keeps_its_origin) {
  const SceneDesc scene = scene_of(
      "model( mesh \"box.dae\" mesh_fit 0 mesh_pose [10 20 30 0 0 90] mesh_scale 2 ) "
      "model( mesh \"box.dae\" mesh_fit 0 mesh_scale [1 -3 1] size [5 5 5] )");
  const ModelDesc& first = scene.models.at(0);
  EXPECT_EQ(first.mesh->low, (geom::Vec3{9, 18, 29.5}));
  EXPECT_EQ(first.mesh->high, (geom::Vec3{11, 22, 30.5}));
  EXPECT_EQ(first.size, (geom::Size{2, 4, 1}));
  EXPECT_EQ(first.blocks.at(0).z_min, 29.5);
  const ModelDesc& second = scene.models.at(1);
  EXPECT_EQ(extent_of(second), (geom::Vec3{2, 3, 0.5})) << "the size does not scale it";
  EXPECT_EQ(second.size, (geom::Size{5, 5, 5})) << "it is what devices tell";
  EXPECT_THAT(scene.warnings, testing::IsEmpty());
}

TEST(MeshWord, lengths_and_angles_of_its_pose_are_in_the_units_of_the_file) {
  const SceneDesc scene = scene_of(
      "unit_length \"cm\"\nunit_angle \"radians\"\n"
      "model( mesh \"box.dae\" mesh_fit 0 mesh_pose [100 0 0 0 0 1.5707963267948966] )");
  EXPECT_NEAR(scene.models.at(0).mesh->high.x, 1.5, 1e-6);
  EXPECT_NEAR(scene.models.at(0).mesh->high.y, 1, 1e-6);
}

TEST(MeshWord, its_placement_is_written_back) {
  const SceneDesc scene = scene_of(
      "model( mesh \"box.dae\" mesh_pose [0 0 0 -90 12.5 0] ) model( mesh \"box.dae\" mesh_scale 0.1 ) "
      "model( mesh \"box.dae\" mesh_fit 0 mesh_pose [0.1 0.2 0.3 0 0 30] mesh_scale [1 -1 1] ) "
      "position( mesh \"box.dae\" mesh_fit 0 size [1 1 1] )");
  const Result<std::string> text = write_world(scene, "w/b.world");
  ASSERT_TRUE(text) << text.error().line();
  EXPECT_THAT(*text, HasSubstr("mesh_pose [0 0 0 -90 12.5 0]"));
  EXPECT_THAT(*text, HasSubstr("mesh_scale [1 -1 1]"));
  EXPECT_THAT(*text, HasSubstr("mesh_fit 0"));
  const SceneDesc again = scene_of(*text);
  EXPECT_EQ(difference(scene, again), "");
  ASSERT_EQ(again.models.size(), scene.models.size());
  for (std::size_t row = 0; row < scene.models.size(); ++row) {
    EXPECT_EQ(scene.models[row].mesh->low, again.models[row].mesh->low) << row;
    EXPECT_EQ(scene.models[row].mesh->high, again.models[row].mesh->high) << row;
  }
}

TEST(MeshWord, tells_what_is_wrong_with_a_placement) {
  const auto told = [](const std::string& words) {
    const Loaded loaded = load("\nmodel( mesh \"box.dae\" " + words + " )");
    return loaded.scene ? loaded.scene->warnings.empty() ? "loaded" : loaded.scene->warnings.front()
                        : loaded.scene.error().line();
  };
  EXPECT_THAT(told("mesh_pose [0 0 0 90]"), HasSubstr("w/a.world:2: \"mesh_pose\" needs"));
  EXPECT_THAT(told("mesh_scale [1 2]"), HasSubstr("w/a.world:2: \"mesh_scale\" needs"));
  for (const char* scale : {"0", "1e7", "[1 0 1]"})
    EXPECT_THAT(told(std::string("mesh_scale ") + scale), HasSubstr("\"mesh_scale\" takes numbers from"))
        << scale;
  EXPECT_THAT(
      told("mesh_scale 1e6 mesh_fit 0"),
      HasSubstr(
          "mesh \"w/box.dae\", with its mesh_scale and mesh_pose, is broken: a corner is not a number"));
  EXPECT_THAT(told("mesh_pose [1 0 0 0 0 0]"),
              HasSubstr("w/a.world:2: the place in \"mesh_pose\" has no effect on a fitted mesh"));
  EXPECT_THAT(scene_of("model( mesh_fit 0 )").warnings,
              ElementsAre(HasSubstr("\"mesh_fit\" has no effect without \"mesh\"")));
}

TEST(MeshWord, warns_of_a_file_in_another_unit) {
  const auto told = [](const std::string& words, double meter) {
    mesh::TestCollada of;  // the corners stay those of a box of 2 x 1 x 0.5
    std::string text = mesh::test_collada(of);
    text.replace(text.find("meter=\"1\""), 9, fmt::format("meter=\"{}\"", meter));
    const Loaded loaded = load("model( mesh \"b.dae\" " + words + " )", {{"w/b.dae", text}});
    if (!loaded.scene) return loaded.scene.error().line();
    return loaded.scene->warnings.empty() ? std::string("none") : loaded.scene->warnings.front();
  };
  EXPECT_THAT(told("", 237),
              HasSubstr("w/a.world:1: mesh \"w/b.dae\" is 474 x 237 x 118.5 m large: mesh_scale"));
  EXPECT_THAT(told("mesh_fit 0 size [1 1 1]", 237), HasSubstr("474 x 237 x 118.5 m large"));
  EXPECT_THAT(told("", 0.0001), HasSubstr("is 0.0002 x 0.0001 x 5e-05 m large"));
  EXPECT_EQ(told("", 50), "none");
  EXPECT_EQ(told("size [1 1 1]", 237), "none");
  EXPECT_EQ(told("mesh_scale 1", 237), "none");
}

TEST(MeshWord, a_file_of_stl_is_a_body) {
  const Loaded loaded = load("model( mesh \"box.stl\" )", {{"w/box.stl", mesh::test_binary_stl()}});
  ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
  EXPECT_EQ(loaded.scene->models.at(0).size, (geom::Size{2, 1, 0.5}));
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
              HasSubstr("mesh \"w/a.png\" is not a mesh"));
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
