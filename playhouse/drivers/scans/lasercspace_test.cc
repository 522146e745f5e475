// How far a disc could drive, by the triangle of its way, its radius and an obstacle.

#include "playhouse/drivers/scans/lasercspace.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "playhouse/drivers/testing/driver_bench.h"
#include "playhouse/geom/trig.h"

namespace playhouse::drivers {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
namespace lsr = wire::laser;

/// Beams of 10 degrees from -90 on.
lsr::Data scan_of(std::vector<float> ranges) {
  lsr::Data scan;
  scan.min_angle = static_cast<float>(geom::radians(-90));
  scan.resolution = static_cast<float>(geom::radians(10));
  scan.max_angle = static_cast<float>(geom::radians(-90 + 10 * (static_cast<int>(ranges.size()) - 1)));
  scan.max_range = 8;
  scan.ranges = std::move(ranges);
  return scan;
}

constexpr std::size_t kAhead = 9;  // of 19 beams

TEST(LaserCSpace, shortens_the_beam_of_an_obstacle_by_the_radius_and_those_beside_by_less) {
  std::vector<float> ranges(19, 8.0f);
  ranges[kAhead] = 2;
  const std::vector<float> made = LaserCSpace{0.5, 1}.scan(scan_of(ranges))->ranges;
  EXPECT_FLOAT_EQ(made[kAhead], 1.5f);
  // The obstacle is 2 sin a beside the way, and 2 cos a along it.
  const double a = geom::radians(10);
  const double beside = 2 * std::sin(a);
  EXPECT_NEAR(static_cast<double>(made[kAhead + 1]), 2 * std::cos(a) - std::sqrt(0.25 - beside * beside),
              1e-5);
  EXPECT_FLOAT_EQ(made[kAhead + 1], made[kAhead - 1]);
  EXPECT_FLOAT_EQ(made[kAhead + 2], 7.5f) << "2 sin 20 degrees are 0.68 m: it passes by";
  EXPECT_FLOAT_EQ(made[0], 7.5f) << "what is beyond the end of a beam is not known to be free";
}

TEST(LaserCSpace, every_other_end_counts_with_a_step_of_2) {
  std::vector<float> ranges(19, 8.0f);
  ranges[kAhead] = 2;  // of an odd number
  const std::vector<float> made = LaserCSpace{0.5, 2}.scan(scan_of(ranges))->ranges;
  EXPECT_FLOAT_EQ(made[kAhead], 1.5f) << "its own beam ends there";
  EXPECT_FLOAT_EQ(made[kAhead + 1], 7.5f);
}

TEST(LaserCSpace, a_robot_beside_an_obstacle_may_drive_away_from_it) {
  std::vector<float> ranges(19, 8.0f);
  ranges[0] = 0.3f;  // on the right, nearer than its radius
  const std::vector<float> made = LaserCSpace{0.5, 1}.scan(scan_of(ranges))->ranges;
  EXPECT_EQ(made[0], 0);
  EXPECT_EQ(made[1], 0);
  EXPECT_FLOAT_EQ(made[18], 7.5f);
}

TEST(LaserCSpace, a_point_drives_as_far_as_the_beams) {
  EXPECT_THAT(LaserCSpace({0, 1}).scan(scan_of({1, 2, 3}))->ranges, ElementsAre(1, 2, 3));
}

TEST(LaserCSpace, takes_what_is_no_range_for_no_way) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(),
                  kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_THAT(LaserCSpace({0.5, 1}).scan(scan_of({kNan, -kInfinity, 0, -1}))->ranges, Each(0));
  EXPECT_THAT(LaserCSpace({0.5, 1}).scan(scan_of({kInfinity}))->ranges, ElementsAre(7.5f));
  EXPECT_THAT(LaserCSpace({0.5, 1}).scan(scan_of({}))->ranges, ElementsAre());
  lsr::Data bad = scan_of({1, 2});
  bad.min_angle = kNan;
  EXPECT_FALSE(LaserCSpace({0.5, 1}).scan(bad));
}

TEST(LaserCSpace, takes_no_scan_that_would_hold_up_all_others) {
  EXPECT_TRUE(LaserCSpace({0.5, 1000}).scan(scan_of(std::vector<float>(LaserCSpace::kMostBeams, 1))));
  EXPECT_FALSE(LaserCSpace({0.5, 1}).scan(scan_of(std::vector<float>(LaserCSpace::kMostBeams + 1, 1))));
}

TEST(LaserCSpaceDriver, says_what_is_wrong_with_its_options) {
  const auto fault = [](const std::string& options) {
    return testing::fault_of(
        "driver( name \"dummy\" provides [\"laser:0\"] )\n"
        "driver( name \"lasercspace\" provides [\"laser:1\"] requires [\"laser:0\"] " +
        options + " )");
  };
  EXPECT_EQ(fault("radius -1"), "test.cfg:2: radius is 0 at least");
  EXPECT_EQ(fault("step 0"), "test.cfg:2: step is from 1 to 1000");
}

}  // namespace
}  // namespace playhouse::drivers
