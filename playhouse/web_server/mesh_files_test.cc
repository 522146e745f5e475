#include "playhouse/web_server/mesh_files.h"

#include <gtest/gtest.h>

#include "playhouse/mesh/testing_meshes.h"
#include "playhouse/replicate/prototypes.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::web_server {
namespace {

TEST(MeshFiles, has_a_binary_gltf_of_each_mesh_where_the_scene_text_says) {
  config::MemoryFiles files({{"box.dae", mesh::test_collada()}});
  const auto scene = scene::load_world_text(
      "model( mesh \"box.dae\" )\nmodel( mesh \"box.dae\" color \"green\" )\nmodel( mesh \"box.dae\" size [1 "
      "1 1] )\nmodel()",
      "a.world", files);
  ASSERT_TRUE(scene) << scene.error().line();
  const replicate::Prototypes prototypes(*scene);
  ASSERT_EQ(prototypes.meshes().size(), 2u);
  EXPECT_NE(prototypes.texts().find(R"("mesh":"meshes/1.glb")"), std::string::npos);
  EXPECT_EQ(prototypes.texts().find("meshes/2.glb"), std::string::npos);

  MeshFiles served(prototypes.meshes());
  const MeshFiles::File* first = served.find("/meshes/0.glb");
  const MeshFiles::File* second = served.find("/meshes/1.glb");
  ASSERT_TRUE(first && second);
  EXPECT_NE(first->etag, second->etag);
  EXPECT_EQ(served.find("/meshes/0.glb"), first) << "made once";
  for (const char* path : {"/meshes/2.glb", "/meshes/", "meshes/0.glb", "/meshes/00.glb"})
    EXPECT_EQ(served.find(path), nullptr) << path;
  const auto read = mesh::read_mesh("a.glb", mesh::test_files({{"a.glb", *second->bytes}}));
  ASSERT_TRUE(read) << read.error().line();
  EXPECT_NEAR(read->mesh.high.x, 0.5, 1e-6);
  EXPECT_NEAR(read->mesh.high.z, 1, 1e-6);
}

}  // namespace
}  // namespace playhouse::web_server
