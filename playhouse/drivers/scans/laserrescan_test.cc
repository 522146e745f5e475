// Scans at other directions, whose ranges follow from the beams beside them.

#include "playhouse/drivers/scans/laserrescan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "playhouse/drivers/testing/driver_bench.h"

namespace playhouse::drivers {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::FloatNear;
namespace lsr = wire::laser;

/// Beams at -20, -10, 0, 10 and 20 degrees.
lsr::Data five_beams() {
  const auto rad = [](double degrees) { return static_cast<float>(geom::radians(degrees)); };
  return {rad(-20), rad(20), rad(10), 8, {1, 2, 4, 2, 1}, {10, 20, 40, 20, 10}, 3};
}

LaserRescan over(double from, double to, int beams) {
  return {geom::radians(from), geom::radians(to), beams};
}

TEST(LaserRescan, has_the_same_scan_at_the_same_directions) {
  const lsr::Data made = *over(-20, 20, 5).scan(five_beams());
  EXPECT_EQ(made.ranges, five_beams().ranges);
  EXPECT_EQ(made.intensity, five_beams().intensity);
  EXPECT_EQ(made.max_range, 8);
  EXPECT_EQ(made.id, 3u);
}

TEST(LaserRescan, interpolates_between_two_beams) {
  const lsr::Data made = *over(-5, 7.5, 6).scan(five_beams());  // every 2.5 degrees
  EXPECT_THAT(made.ranges, ElementsAre(FloatNear(3, 1e-5f), FloatNear(3.5f, 1e-5f), FloatNear(4, 1e-5f),
                                       FloatNear(3.5f, 1e-5f), FloatNear(3, 1e-5f), FloatNear(2.5f, 1e-5f)));
  EXPECT_FLOAT_EQ(made.min_angle, static_cast<float>(geom::radians(-5)));
  EXPECT_FLOAT_EQ(made.resolution, static_cast<float>(geom::radians(2.5)));
}

TEST(LaserRescan, sees_nothing_where_the_laser_does_not_look) {
  EXPECT_THAT(over(-40, 40, 5).scan(five_beams())->ranges, ElementsAre(8, 1, 4, 1, 8));
  EXPECT_THAT(over(-40, 40, 5).scan(five_beams())->intensity, ElementsAre(0, 10, 40, 10, 0));
  EXPECT_THAT(over(-10, 10, 3).scan({-1, 1, 0.1f, 8, {}, {}, 1})->ranges, Each(8));
}

TEST(LaserRescan, may_have_one_beam) {
  EXPECT_THAT(over(0, 0, 1).scan(five_beams())->ranges, ElementsAre(4));
}

TEST(LaserRescan, has_nothing_of_a_scan_whose_angles_are_none) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    EXPECT_FALSE(over(-10, 10, 3).scan({bad, 1, 0.1f, 8, {1, 2}, {}, 1}));
    EXPECT_FALSE(over(-10, 10, 3).scan({-1, 1, bad, 8, {1, 2}, {}, 1}));
  }
  EXPECT_FALSE(over(-10, 10, 3).scan({-1, 1, 0, 8, {1, 2}, {}, 1}));
}

TEST(LaserRescan, tells_its_own_angles) {
  const lsr::Config config = over(-20, 20, 5).config({-1, 1, 0.1f, 8, 0.01f, 1, 10});
  EXPECT_FLOAT_EQ(config.resolution, static_cast<float>(geom::radians(10)));
  EXPECT_EQ(config.max_range, 8);
}

TEST(LaserRescanDriver, says_what_is_wrong_with_its_beams) {
  const auto fault = [](const std::string& options) {
    return testing::fault_of(
        "driver( name \"dummy\" provides [\"laser:0\"] )\n"
        "driver( name \"laserrescan\" provides [\"laser:1\"] requires [\"laser:0\"] " +
        options + " )");
  };
  EXPECT_EQ(fault("scan_count 0"), "test.cfg:2: scan_count is from 1 to 100000");
  EXPECT_EQ(fault("min_angle 100"), "test.cfg:2: min_angle is not above max_angle");
}

}  // namespace
}  // namespace playhouse::drivers
