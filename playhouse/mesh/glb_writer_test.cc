#include "playhouse/mesh/glb_writer.h"

#include <gtest/gtest.h>

#include "playhouse/mesh/testing_meshes.h"

namespace playhouse::mesh {
namespace {

TEST(GlbWriter, makes_a_file_that_is_read_as_the_same_mesh) {
  const Result<MeshFile> file = read_mesh(
      "d/box.gltf",
      test_files({{"d/box.gltf", test_gltf("box.bin", R"(,"translation":[3,2,1])",
                                           R"(,"images":[{"uri":"t.png"}],"textures":[{"source":0}])",
                                           R"(,"baseColorTexture":{"index":0})")},
                  {"d/box.bin", test_gltf_buffer()},
                  {"d/t.png", test_png()}}));
  ASSERT_TRUE(file) << file.error().line();
  const Mesh& mesh = file->mesh;
  const Result<MeshFile> again = read_mesh("a.glb", test_files({{"a.glb", write_glb(mesh)}}));
  ASSERT_TRUE(again) << again.error().line();
  EXPECT_NEAR(again->mesh.low.x, mesh.low.x, 1e-6);
  EXPECT_NEAR(again->mesh.low.y, mesh.low.y, 1e-6);
  EXPECT_NEAR(again->mesh.high.z, mesh.high.z, 1e-6);
  ASSERT_EQ(again->mesh.surfaces.size(), mesh.surfaces.size());
  EXPECT_EQ(again->mesh.surfaces[0].corners.size(), mesh.surfaces[0].corners.size());
  ASSERT_EQ(again->mesh.images.size(), 1u);
  EXPECT_EQ(again->mesh.images[0].rgba, mesh.images.at(0).rgba);
  const Material &was = mesh.materials.at(mesh.surfaces[0].material),
                 &is = again->mesh.materials.at(again->mesh.surfaces[0].material);
  EXPECT_EQ(is.base, was.base);
  EXPECT_EQ(is.metallic, was.metallic);
  EXPECT_EQ(is.is_two_sided, was.is_two_sided);
  EXPECT_EQ(is.opacity, was.opacity);
  EXPECT_EQ(is.texture, 0u);
}

TEST(GlbWriter, says_of_opacity_what_makes_a_difference) {
  const Result<MeshFile> file = read_mesh("box.obj", test_files({{"box.obj", test_obj()}}));
  ASSERT_TRUE(file) << file.error().line();
  const auto written = [&](Opacity opacity, float alpha) {
    Mesh mesh = file->mesh;
    for (Material& material : mesh.materials) {
      material.opacity = opacity;
      material.base[3] = alpha;
    }
    return write_glb(mesh);
  };
  EXPECT_EQ(written(Opacity::kHoles, 1).find("alphaMode"), std::string::npos);
  EXPECT_NE(written(Opacity::kHoles, 0.4f).find(R"("alphaMode":"MASK","alphaCutoff":0.5)"),
            std::string::npos);
  EXPECT_EQ(written(Opacity::kClear, 1).find("alphaMode"), std::string::npos);
  EXPECT_NE(written(Opacity::kClear, 0.4f).find(R"("alphaMode":"BLEND")"), std::string::npos);
}

}  // namespace
}  // namespace playhouse::mesh
