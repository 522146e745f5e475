#include "playhouse/mesh/fit.h"

#include <gtest/gtest.h>

#include "playhouse/mesh/parts.h"
#include "playhouse/mesh/testing_meshes.h"

namespace playhouse::mesh {
namespace {

Mesh box() {
  const Result<MeshFile> file = read_mesh("a.dae", test_files({{"a.dae", test_collada()}}));
  return file ? file->mesh : Mesh();
}

TEST(Fit, stands_on_the_ground_about_the_middle_as_large_as_it_is_told) {
  Mesh of = box();
  of.lights.push_back({});
  of.physics.emplace();
  of.physics->shapes.push_back({ShapeKind::kBox, {}, {}, {1, 0.5, 0.25}, {}, {}});
  of.physics->shapes.push_back({ShapeKind::kHull, {}, {}, {}, {{1, 0, 0.25}}, {}});
  const Mesh mesh = fitted(of, {4, 3, 2});
  EXPECT_NEAR(mesh.low.x, -2, 1e-6);
  EXPECT_NEAR(mesh.high.y, 1.5, 1e-6);
  EXPECT_NEAR(mesh.low.z, 0, 1e-6);
  EXPECT_NEAR(mesh.high.z, 2, 1e-6);
  EXPECT_NEAR(mesh.lights.at(0).p.z, 1, 1e-9);
  EXPECT_NEAR(mesh.physics->shapes[0].half.x, 2, 1e-6);
  EXPECT_NEAR(mesh.physics->shapes[0].half.z, 1, 1e-6);
  EXPECT_NEAR(mesh.physics->shapes[0].p.z, 1, 1e-6);
  const Shape& hull = mesh.physics->shapes[1];
  EXPECT_NEAR((hull.p + hull.points[0]).x, 2, 1e-6);
  EXPECT_NEAR((hull.p + hull.points[0]).z, 2, 1e-6);
  for (const auto& n : mesh.surfaces[0].normal) EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-5);
}

TEST(Fit, changes_nothing_of_what_has_that_size) {
  const Mesh once = fitted(box(), {2, 1, 0.5}), again = fitted(once, once.high - once.low);
  EXPECT_EQ(once.surfaces[0].p, again.surfaces[0].p);
}

TEST(Parts, are_what_shares_no_corner) {
  Mesh two = box();
  Surface other = two.surfaces[0];
  for (auto& p : other.p) p[0] += 5;
  two.surfaces.push_back(other);
  const auto parts = parts_of(two, 8);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].size(), 8u);
  EXPECT_EQ(parts_of(two, 1).size(), 1u);
}

}  // namespace
}  // namespace playhouse::mesh
