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

}  // namespace
}  // namespace playhouse::replicate
