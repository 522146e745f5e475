#include "playhouse/geom/trapezoids.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>

namespace playhouse::geom {
namespace {

using Points = std::vector<Vec2>;

std::vector<Trapezoid> cut(const std::vector<Points>& outlines) {
  std::vector<Outline> spans(outlines.begin(), outlines.end());
  return trapezoids(spans);
}

double area(const std::vector<Trapezoid>& parts) {
  double sum = 0;
  for (const Trapezoid& t : parts)
    sum += (t.y_high - t.y_low) * (t.right_low - t.left_low + t.right_high - t.left_high) / 2;
  return sum;
}

const Points kSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

TEST(Trapezoids, of_a_square_are_one_and_of_nothing_none) {
  const std::vector<Trapezoid> parts = cut({kSquare});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].y_low, 0);
  EXPECT_EQ(parts[0].y_high, 4);
  EXPECT_EQ(parts[0].left_low, 0);
  EXPECT_EQ(parts[0].right_high, 4);
  EXPECT_TRUE(cut({}).empty());
  EXPECT_TRUE(cut({{{0, 0}, {1, 0}, {2, 0}}}).empty()) << "no area";
}

TEST(Trapezoids, leave_holes_out_and_fill_what_is_in_a_hole) {
  const Points hole{{1, 1}, {1, 3}, {3, 3}, {3, 1}}, island{{1.5, 1.5}, {2.5, 1.5}, {2.5, 2.5}, {1.5, 2.5}};
  EXPECT_DOUBLE_EQ(area(cut({kSquare, hole})), 12);
  EXPECT_EQ(cut({kSquare, hole}).size(), 4u) << "below, left, right and above";
  EXPECT_DOUBLE_EQ(area(cut({kSquare, hole, island})), 13);
}

TEST(Trapezoids, of_a_shape_that_is_not_convex_have_its_area) {
  EXPECT_DOUBLE_EQ(area(cut({{{0, 0}, {3, 0}, {3, 3}, {1.5, 1}, {0, 3}}})), 6);
}

TEST(EachLine, goes_through_the_middles_of_rows_within_its_limits) {
  const Trapezoid t =
      cut({{{0, 0.5}, {4, 0.5}, {4, 4.5}}}).at(0);  // a triangle, its left side from (0, 0.5) to (4, 4.5)
  std::vector<std::array<double, 3>> lines;
  each_line(t, 1, 3, [&](int line, double left, double right) {
    lines.push_back({line + 0.0, left, right});
  });
  EXPECT_EQ(lines, (std::vector<std::array<double, 3>>{{1, 1, 4}, {2, 2, 4}}));
  lines.clear();
  each_line(t, -9, 99, [&](int line, double left, double right) {
    lines.push_back({line + 0.0, left, right});
  });
  EXPECT_EQ(lines.size(), 4u);
}

/// A star about the origin: its corners are in order of their bearings, so it never crosses itself. The
/// oracle is the shoelace formula.
RC_GTEST_PROP(Trapezoids, have_the_area_of_any_star_and_stay_apart, ()) {
  const auto radii =
      *rc::gen::container<std::vector<int>>(*rc::gen::inRange(3, 40), rc::gen::inRange(1, 100));
  Points star;
  double doubled = 0;
  for (std::size_t k = 0; k < radii.size(); ++k) {
    const double bearing = kTwoPi * static_cast<double>(k) / static_cast<double>(radii.size());
    star.push_back({radii[k] * std::cos(bearing), radii[k] * std::sin(bearing)});
  }
  for (std::size_t k = 0; k < star.size(); ++k) doubled += cross(star[k], star[(k + 1) % star.size()]);
  const std::vector<Trapezoid> parts = cut({star});
  RC_ASSERT(std::fabs(area(parts) - doubled / 2) < 1e-9 * doubled);
  for (const Trapezoid& t : parts) {
    RC_ASSERT(t.y_low < t.y_high);
    RC_ASSERT(t.left_low <= t.right_low + 1e-9);
    RC_ASSERT(t.left_high <= t.right_high + 1e-9);
  }
}

}  // namespace
}  // namespace playhouse::geom
