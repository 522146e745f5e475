// Where a robot was at times between, before and after those of its poses.

#include "playhouse/drivers/algorithm/recent_poses.h"

#include <gtest/gtest.h>

namespace playhouse::drivers {
namespace {

using geom::radians;

TEST(RecentPoses, between_two_poses_it_is_in_proportion_to_the_time_and_turns_the_short_way) {
  RecentPoses poses;
  EXPECT_FALSE(poses.at(1));
  poses.add(1, {0, 2, 0, radians(170)});
  poses.add(2, {4, 0, 0, radians(-170)});
  const geom::Pose between = *poses.at(1.75);
  EXPECT_NEAR(between.x, 3, 1e-12);
  EXPECT_NEAR(between.y, 0.5, 1e-12);
  EXPECT_NEAR(geom::degrees(between.a), -175, 1e-9);
  EXPECT_EQ(*poses.at(1), (geom::Pose{0, 2, 0, radians(170)}));
}

TEST(RecentPoses, at_a_time_of_which_it_knows_nothing_it_is_the_newest) {
  RecentPoses poses;
  for (int k = 1; k <= 100; ++k) poses.add(k, {static_cast<double>(k), 0, 0, 0});
  EXPECT_EQ(poses.at(101)->x, 100);
  EXPECT_EQ(poses.at(37.5)->x, 37.5);
  EXPECT_EQ(poses.at(36.5)->x, 100) << "64 are kept";
}

TEST(RecentPoses, a_time_that_goes_back_begins_anew) {
  RecentPoses poses;
  poses.add(1, {1, 0, 0, 0});
  poses.add(3, {3, 0, 0, 0});
  poses.add(2, {7, 0, 0, 0});
  EXPECT_EQ(poses.at(1.5)->x, 7);
  EXPECT_EQ(poses.at(2.5)->x, 7);
}

}  // namespace
}  // namespace playhouse::drivers
