#include "playhouse/replicate/physics_text.h"

#include <gtest/gtest.h>

namespace playhouse::replicate {
namespace {

using world::SolidCorners;

SolidCorners prism(double z_low, double z_high) {
  return {{0, 0, z_low},  {1, 0, z_low},  {1, 2.00004, z_low},
          {0, 0, z_high}, {1, 0, z_high}, {1, 2.00004, z_high}};
}

TEST(PhysicsText, prisms_are_told_by_their_outlines_and_other_solids_by_their_corners) {
  world::PhysicsShapes shapes;
  shapes.fixed = {prism(0, 1.5)};
  shapes.bodies = {{world::ModelId{7}, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}};
  EXPECT_EQ(*physics_text(shapes),
            "{\"physics\":{\"fixed\":[{\"z\":[0,1.5],\"loop\":[0,0,1,0,1,2]}],\n"
            "\"bodies\":[{\"model\":7,\"solids\":[{\"corners\":"
            "[0,0,0,1,0,0,0,1,0,0,0,1]}]}]}}\n");
}

TEST(PhysicsText, what_leans_or_tapers_is_no_prism) {
  for (const std::size_t corner : {0u, 4u}) {
    world::PhysicsShapes shapes;
    shapes.fixed = {prism(0, 1)};
    shapes.fixed[0][corner].x += 0.1;
    EXPECT_NE(physics_text(shapes)->find("corners"), std::string::npos);
    shapes.fixed = {prism(0, 1)};
    shapes.fixed[0][corner].z += 0.1;
    EXPECT_NE(physics_text(shapes)->find("corners"), std::string::npos);
  }
}

TEST(PhysicsText, no_more_is_told_than_a_page_can_draw) {
  world::PhysicsShapes shapes;
  shapes.bodies = {{world::ModelId{0}, {SolidCorners(kPhysicsCorners), SolidCorners(1)}}};
  const Result<std::string> text = physics_text(shapes);
  ASSERT_FALSE(text);
  EXPECT_NE(text.error().text.find("physics has 400001 corners"), std::string::npos) << text.error().text;
}

TEST(PhysicsText, nothing_is_two_empty_lists) {
  EXPECT_EQ(*physics_text({}), "{\"physics\":{\"fixed\":[],\n\"bodies\":[]}}\n");
}

}  // namespace
}  // namespace playhouse::replicate
