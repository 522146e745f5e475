#include "playhouse/mesh/fit.h"

#include <gtest/gtest.h>

#include <cmath>

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
  const CollisionShape& hull = mesh.physics->shapes[1];
  EXPECT_NEAR((hull.p + hull.points[0]).x, 2, 1e-6);
  EXPECT_NEAR((hull.p + hull.points[0]).z, 2, 1e-6);
  for (const auto& n : mesh.surfaces[0].normal) EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-5);
}

/// Degrees about x, y and z.
Placement turned(double roll, double pitch, double yaw) {
  return {{}, {geom::radians(roll), geom::radians(pitch), geom::radians(yaw)}, {1, 1, 1}, false};
}

double volume_of(const Mesh& mesh) {
  double volume = 0;
  for (const auto& [a, b, c] : mesh.surfaces.at(0).corners) {
    const auto at = [&](std::uint32_t k) {
      const auto& p = mesh.surfaces[0].p[k];
      return geom::Vec3{p[0], p[1], p[2]};
    };
    volume += dot(at(a), cross(at(b), at(c))) / 6;
  }
  return volume;
}

TEST(Placed, turns_about_x_then_y_then_z_and_quarter_turns_are_exact) {
  // The box is 2 x 1 x 0.5.
  EXPECT_EQ(placed(box(), turned(90, 0, 0)).high, (geom::Vec3{1, 0.25, 0.5}));
  EXPECT_EQ(placed(box(), turned(0, 90, 0)).high, (geom::Vec3{0.25, 0.5, 1}));
  EXPECT_EQ(placed(box(), turned(0, 0, 90)).high, (geom::Vec3{0.5, 1, 0.25}));
  EXPECT_EQ(placed(box(), turned(90, 0, 90)).high, (geom::Vec3{0.25, 1, 0.5}));
  EXPECT_EQ(placed(box(), turned(-90, 180, 270)).high, (geom::Vec3{0.25, 1, 0.5}));
  Mesh of = box();
  of.lights.push_back({});
  of.lights[0].p = {1, 2, 3};
  const Mesh mesh = placed(of, turned(90, 0, 90));  // (x, y, z) -> (x, -z, y) -> (z, x, y)
  EXPECT_EQ(mesh.lights[0].p, (geom::Vec3{3, 1, 2}));
  EXPECT_EQ(mesh.lights[0].d, (geom::Vec3{-1, 0, 0}));
  EXPECT_NEAR(placed(box(), turned(0, 0, 45)).high.x, 1.5 / std::sqrt(2.0), 1e-6);
}

TEST(Placed, scales_first_and_moves_last) {
  Placement at = turned(0, 0, 90);
  at.scale = {0.5, 2, 1};
  at.p = {10, 20, 30};
  const Mesh mesh = placed(box(), at);
  EXPECT_EQ(mesh.low, (geom::Vec3{9, 19.5, 29.75}));
  EXPECT_EQ(mesh.high, (geom::Vec3{11, 20.5, 30.25}));
}

TEST(Placed, keeps_the_outside_of_what_it_mirrors) {
  Placement at;
  at.scale = {1, -1, 1};
  const Mesh mesh = placed(box(), at);
  EXPECT_NEAR(volume_of(mesh), 1, 1e-6);
  const Surface& surface = mesh.surfaces[0];
  for (std::size_t i = 0; i < surface.p.size(); ++i) {
    double out = 0;
    for (std::size_t k = 0; k < 3; ++k) out += static_cast<double>(surface.p[i][k] * surface.normal[i][k]);
    EXPECT_GT(out, 0);
  }
}

TEST(Placed, takes_the_shapes_for_physics_along) {
  Mesh of = box();
  of.physics.emplace();
  of.physics->shapes.push_back({ShapeKind::kBox, {1, 0, 0}, {}, {1, 0.5, 0.25}, {}, {}});
  of.physics->shapes.push_back({ShapeKind::kCylinder, {}, {}, {0.1, 0.1, 1}, {}, {}});
  of.physics->shapes.push_back(
      {ShapeKind::kTriangles, {}, {}, {}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}}});
  Placement at = turned(0, 0, 90);
  at.scale = {2, -2, 2};
  at.p = {0, 0, 5};
  const Mesh mesh = placed(of, at);
  const std::vector<CollisionShape>& shapes = mesh.physics->shapes;
  EXPECT_EQ(shapes[0].p, (geom::Vec3{0, 2, 5}));
  EXPECT_EQ(shapes[0].half, (geom::Vec3{2, 1, 0.5}));
  EXPECT_NEAR(std::fabs((shapes[0].q * geom::Vec3{1, 0, 0}).y), 1, 1e-9);
  EXPECT_EQ(shapes[1].half, (geom::Vec3{0.2, 0.2, 2}));
  EXPECT_EQ(shapes[2].points.at(0), (geom::Vec3{0, 2, 0}));
  EXPECT_EQ(shapes[2].points.at(1), (geom::Vec3{2, 0, 0}));
  EXPECT_EQ(shapes[2].corners.at(0), (std::array<std::uint32_t, 3>{0, 2, 1}));
}

TEST(Placed, is_what_fits_afterwards) {
  const Mesh mesh = fitted(placed(box(), turned(-90, 0, 0)), {1, 1, 1});
  EXPECT_NEAR(mesh.low.z, 0, 1e-6);
  EXPECT_NEAR(mesh.high.z, 1, 1e-6);
  EXPECT_EQ(mesh.high.x, 0.5);
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
