#include "playhouse/controllers/free_way.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "playhouse/geom/pose.h"

namespace playhouse::controllers {
namespace {

constexpr double kHalf = 0.3;  // m
constexpr Fan kFan{-geom::kPi / 2, geom::radians(1)};

/// A scan of 181 beams out to 8 m in which beams from one bearing to another, in degrees, end after `range`.
std::vector<float> scan_with(int from, int to, float range,
                             std::vector<float> scan = std::vector<float>(181, 8)) {
  for (int degrees = from; degrees <= to; ++degrees) scan[static_cast<std::size_t>(degrees + 90)] = range;
  return scan;
}

/// In degrees.
double way(const std::vector<float>& scan, double wanted) {
  const auto found = free_way(scan, kFan, kHalf, geom::radians(wanted));
  return found ? std::round(geom::degrees(found->bearing)) : 999;
}

TEST(FreeWay, is_what_is_wanted_where_that_is_free) {
  const std::vector<float> scan(181, 8);
  EXPECT_EQ(way(scan, 0), 0);
  EXPECT_EQ(way(scan, 40), 40);
  EXPECT_EQ(way(scan, -90), -90);
  EXPECT_EQ(way(scan, 170), 90) << "as far as it sees";
}

TEST(FreeWay, leads_by_what_is_in_the_way_with_room_for_the_robot) {
  const double left = way(scan_with(-30, 10, 0.7f), 0), right = way(scan_with(-10, 30, 0.7f), 0);
  EXPECT_GE(left, 10 + 25) << "0.3 m beside what is 0.7 m away";
  EXPECT_EQ(right, -left);
}

TEST(FreeWay, does_not_lead_through_what_is_narrower_than_the_robot) {
  const std::vector<float> gap = scan_with(12, 90, 0.7f, scan_with(-90, -12, 0.7f));
  EXPECT_EQ(way(gap, 0), 999);
  const std::vector<float> door = scan_with(35, 90, 0.7f, scan_with(-90, -35, 0.7f));
  EXPECT_LE(std::fabs(way(door, 20)), 10);
}

TEST(FreeWay, is_none_where_everything_is_near) {
  EXPECT_EQ(way(scan_with(-90, 90, 0.5f), 0), 999);
}

TEST(FreeWay, tells_how_much_is_free_straight_ahead) {
  const std::vector<float> scan = scan_with(-2, 2, 0.5f);
  const auto found = free_way(scan, kFan, kHalf, geom::radians(90));
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->ahead, 0.5, 0.01);
}

}  // namespace
}  // namespace playhouse::controllers
