#include "playhouse/drivers/hardware/wheel_odometry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/base/rng.h"

namespace playhouse::drivers {
namespace {

TEST(WheelOdometry, a_quarter_of_a_circle_ends_where_it_does) {
  WheelOdometry odometry;
  odometry.add({std::acos(0.0), std::acos(0.0)});
  EXPECT_NEAR(odometry.pose().x, 1, 1e-12);
  EXPECT_NEAR(odometry.pose().y, 1, 1e-12);
  EXPECT_NEAR(odometry.pose().a, std::acos(0.0), 1e-12);
  odometry.set({5, 6, 0, 0});
  odometry.add({-2, 0});
  EXPECT_NEAR(odometry.pose().x, 3, 1e-12);
}

TEST(WheelOdometry, steps_between_its_poses_are_those_that_it_was_told) {
  Rng rng(3);
  const auto within = [&rng](double most) { return most * (2 * rng.uniform() - 1); };
  WheelOdometry odometry;
  WheelSteps steps;
  odometry.set({within(100), within(100), 0, within(3)});
  EXPECT_EQ(steps.to(odometry.pose()).distance, 0) << "the first one";
  for (int round = 0; round < 1000; ++round) {
    const WheelStep told{within(0.3), round % 10 == 0 ? 0 : within(2)};
    odometry.add(told);
    const WheelStep step = steps.to(odometry.pose());
    EXPECT_NEAR(step.distance, told.distance, 1e-9);
    EXPECT_NEAR(step.turn, told.turn, 1e-9);
  }
}

TEST(WheelOdometry, jumps_and_what_is_no_number_are_no_steps) {
  WheelSteps steps;
  steps.to({0, 0, 0, 0});
  EXPECT_EQ(steps.to({5, 0, 0, 1}).turn, 0);
  EXPECT_EQ(steps.to({NAN, 0, 0, 1}).distance, 0);
  EXPECT_EQ(steps.to({5, 0, 0, 1}).distance, 0);
  EXPECT_NEAR(steps.to({5, 0, 0, 1.5}).turn, 0.5, 1e-12);
}

}  // namespace
}  // namespace playhouse::drivers
