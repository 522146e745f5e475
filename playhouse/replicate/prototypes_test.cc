#include "playhouse/replicate/prototypes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/mesh/mesh.h"

namespace playhouse::replicate {
namespace {

TEST(Prototypes, tell_the_lights_of_a_mesh_that_have_a_place) {
  mesh::Mesh mesh;
  mesh::Light bulb, spot, sun;
  bulb.p = {1, 2, 3};
  bulb.color = {30, 20, 10};
  spot.kind = mesh::LightKind::kSpot;
  spot.d = {1, 0, 0};
  spot.inner = 0.25;
  spot.outer = 0.5;
  sun.kind = mesh::LightKind::kDirection;
  mesh.lights = {bulb, spot, sun};
  scene::SceneDesc scene;
  scene.models.emplace_back().mesh = std::make_shared<const mesh::Mesh>(mesh);
  const Prototypes prototypes(scene);
  EXPECT_THAT(
      prototypes.texts(),
      testing::HasSubstr(R"("lights":[{"p":[1,2,3],"candela":[30,20,10]},)"
                         R"({"p":[0,0,0],"candela":[1,1,1],"way":[1,0,0],"inner":0.25,"outer":0.5}])"));
}

TEST(Prototypes, have_the_look_of_a_model_for_the_page_in_place_of_its_mesh) {
  scene::SceneDesc scene;
  scene.models.resize(2);
  scene.models[0].mesh = scene.models[1].mesh = std::make_shared<const mesh::Mesh>();
  scene.models[1].look = std::make_shared<const mesh::Mesh>();
  const Prototypes prototypes(scene);
  EXPECT_THAT(prototypes.texts(), testing::HasSubstr(R"("mesh":"meshes/0.glb"})"));
  EXPECT_THAT(prototypes.texts(), testing::HasSubstr(R"("mesh":"meshes/1.glb","painted":true})"));
  EXPECT_EQ(prototypes.meshes().size(), 2u);
}

}  // namespace
}  // namespace playhouse::replicate
