#include "playhouse/geom/convex_hull.h"

#include <gtest/gtest.h>

namespace playhouse::geom {
namespace {

TEST(ConvexHull, has_the_corners_of_a_square_and_nothing_within_or_on_its_sides) {
  const std::vector<Vec2> hull = convex_hull({{1, 1}, {0, 0}, {0.5, 0.5}, {1, 0}, {0.5, 0}, {0, 1}, {0, 0}});
  EXPECT_EQ(hull, (std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
}

TEST(ConvexHull, of_what_has_no_area_has_fewer_than_three_corners) {
  EXPECT_TRUE(convex_hull({}).empty());
  EXPECT_LT(convex_hull({{1, 2}}).size(), 3u);
  EXPECT_LT(convex_hull({{0, 0}, {2, 2}, {1, 1}}).size(), 3u);
}

}  // namespace
}  // namespace playhouse::geom
