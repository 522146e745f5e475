// Modes of drawing as points, lines and triangles; the inside of polygons by their area.

#include "playhouse/bridge/interfaces/drawing/primitives.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/wire/generated/graphics3d.h"

namespace playhouse::drivers {
namespace {

namespace g3d = wire::graphics3d;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Corner n of a row, recognisable by its number.
geom::Vec3 c(int n) {
  return {static_cast<double>(n), 0.5, -0.25};
}

std::vector<geom::Vec3> row_of(int count) {
  std::vector<geom::Vec3> row;
  for (int n = 0; n < count; ++n) row.push_back(c(n));
  return row;
}

/// The numbers of the corners that are made of a row.
std::vector<int> made_of(std::int32_t mode, const std::vector<geom::Vec3>& points, std::size_t corners) {
  const auto made = primitives_of(static_cast<std::uint32_t>(mode), points);
  EXPECT_TRUE(made.has_value());
  EXPECT_EQ(made->corners, corners);
  std::vector<int> numbers;
  for (const geom::Vec3& p : made->points) {
    EXPECT_EQ(p, c(static_cast<int>(p.x)));
    numbers.push_back(static_cast<int>(p.x));
  }
  return numbers;
}

TEST(PrimitivesOf, are_those_of_each_mode) {
  EXPECT_THAT(made_of(g3d::kDrawPoints, row_of(3), 1), ElementsAre(0, 1, 2));
  EXPECT_THAT(made_of(g3d::kDrawLines, row_of(5), 2), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(made_of(g3d::kDrawLineStrip, row_of(3), 2), ElementsAre(0, 1, 1, 2));
  EXPECT_THAT(made_of(g3d::kDrawLineLoop, row_of(3), 2), ElementsAre(0, 1, 1, 2, 2, 0));
  EXPECT_THAT(made_of(g3d::kDrawLineLoop, row_of(2), 2), ElementsAre(0, 1));
  EXPECT_THAT(made_of(g3d::kDrawTriangles, row_of(7), 3), ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_THAT(made_of(g3d::kDrawTriangleStrip, row_of(4), 3), ElementsAre(0, 1, 2, 1, 2, 3));
  EXPECT_THAT(made_of(g3d::kDrawTriangleFan, row_of(4), 3), ElementsAre(0, 1, 2, 0, 2, 3));
  EXPECT_THAT(made_of(g3d::kDrawPolygon, row_of(4), 3), ElementsAre(0, 1, 2, 0, 2, 3));
  EXPECT_THAT(made_of(g3d::kDrawQuads, row_of(9), 3), ElementsAre(0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7));
  EXPECT_THAT(made_of(g3d::kDrawQuadStrip, row_of(5), 3), ElementsAre(0, 1, 2, 1, 2, 3));
  EXPECT_FALSE(primitives_of(10, row_of(3)).has_value());
}

TEST(PrimitivesOf, too_few_corners_are_nothing) {
  for (std::uint32_t mode = 0; mode <= g3d::kDrawPolygon; ++mode) {
    EXPECT_THAT(primitives_of(mode, {})->points, IsEmpty()) << mode;
    if (mode != g3d::kDrawPoints) EXPECT_THAT(primitives_of(mode, row_of(1))->points, IsEmpty()) << mode;
  }
}

TEST(PrimitivesOf, leave_out_shapes_with_a_corner_that_is_nowhere) {
  for (const double bad : {double{NAN}, double{INFINITY}, 1.01 * kFarthest}) {
    std::vector<geom::Vec3> row = row_of(6);
    row[1].z = bad;
    EXPECT_THAT(made_of(g3d::kDrawPoints, row, 1), ElementsAre(0, 2, 3, 4, 5));
    EXPECT_THAT(made_of(g3d::kDrawLines, row, 2), ElementsAre(2, 3, 4, 5)) << "the other pairs stay pairs";
    EXPECT_THAT(made_of(g3d::kDrawLineStrip, row, 2), ElementsAre(2, 3, 3, 4, 4, 5));
    EXPECT_THAT(made_of(g3d::kDrawTriangles, row, 3), ElementsAre(3, 4, 5));
  }
}

double area_of(const Primitives& triangles) {
  EXPECT_EQ(triangles.corners, 3u);
  double area = 0;
  for (std::size_t i = 0; i + 2 < triangles.points.size(); i += 3) {
    const geom::Vec3 *p = &triangles.points[i], u = p[1] - p[0], v = p[2] - p[0];
    area += std::fabs(geom::cross(u, v).z) / 2;
  }
  return area;
}

TEST(Filled, is_the_inside_of_a_polygon_that_is_not_convex) {
  const std::vector<geom::Vec2> arrow{{0, 0}, {4, -3}, {1, 0}, {4, 3}};
  const Primitives made = filled(arrow, 0.25);
  EXPECT_NEAR(area_of(made), 3, 1e-12);
  for (const geom::Vec3& p : made.points) EXPECT_EQ(p.z, 0.25);
}

TEST(Filled, leaves_out_corners_that_are_nowhere) {
  EXPECT_NEAR(area_of(filled(std::vector<geom::Vec2>{{0, 0}, {2, 0}, {NAN, 1}, {2, 2}, {0, 2}}, 0)), 4,
              1e-12);
  EXPECT_THAT(filled(std::vector<geom::Vec2>{{0, 0}, {2, 0}}, 0).points, IsEmpty());
  EXPECT_THAT(filled({}, 0).points, IsEmpty());
}

TEST(Filled, of_an_outline_that_crosses_itself_everywhere_has_a_limit) {
  std::vector<geom::Vec2> star;
  for (std::size_t i = 0; i < kFilledExactly; ++i) {
    const double bearing = 0.01 + 2 * geom::kPi * 45 * static_cast<double>(i) / kFilledExactly;
    star.push_back({std::cos(bearing), std::sin(bearing)});
  }
  const std::size_t points = filled(star, 0).points.size();
  EXPECT_GT(points, 6 * 2000u);
  EXPECT_LE(points, 6 * kFilledExactly * kFilledExactly / 4);
}

TEST(Filled, is_a_fan_beyond_the_limit) {
  std::vector<geom::Vec2> circle;
  constexpr std::size_t kCorners = kFilledExactly + 100;
  for (std::size_t i = 0; i < kCorners; ++i) {
    const geom::Rotation turn = geom::Rotation::of(2 * geom::kPi * static_cast<double>(i) / kCorners);
    circle.push_back({turn.c, turn.s});
  }
  const Primitives made = filled(circle, 0);
  EXPECT_EQ(made.points.size(), 3 * (kCorners - 2));
  EXPECT_NEAR(area_of(made), geom::kPi, 1e-3);
}

}  // namespace
}  // namespace playhouse::drivers
