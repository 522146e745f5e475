// What "lasercutter" leaves of a scan, by the numbers of its beams.

#include "playhouse/drivers/scans/lasercutter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "playhouse/drivers/testing/driver_bench.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
namespace lsr = wire::laser;

constexpr device::Address kWhole{6665, lsr::kCode, 0}, kCut{6665, lsr::kCode, 1};

/// 181 beams from -90 to 90 degrees; beam i has range and intensity i.
lsr::Data half_turn() {
  lsr::Data scan{static_cast<float>(geom::radians(-90)),
                 static_cast<float>(geom::radians(90)),
                 static_cast<float>(geom::radians(1)),
                 200,
                 {},
                 {},
                 7};
  for (int i = 0; i <= 180; ++i) {
    scan.ranges.push_back(static_cast<float>(i));
    scan.intensity.push_back(static_cast<std::uint8_t>(i));
  }
  return scan;
}

LaserCutter window(double from, double to) {
  return {geom::radians(from), geom::radians(to)};
}

TEST(LaserCutter, keeps_the_beams_of_the_window_and_its_edges) {
  const lsr::Data part = *window(-2, 3).scan(half_turn());
  EXPECT_THAT(part.ranges, ElementsAre(88, 89, 90, 91, 92, 93));
  EXPECT_THAT(part.intensity, ElementsAre(88, 89, 90, 91, 92, 93));
  EXPECT_NEAR(static_cast<double>(part.min_angle), geom::radians(-2), 1e-6);
  EXPECT_NEAR(static_cast<double>(part.max_angle), geom::radians(3), 1e-6);
  EXPECT_EQ(part.id, 7u);
  EXPECT_EQ(part.max_range, 200);
}

TEST(LaserCutter, tells_the_directions_of_its_beams_rather_than_those_of_the_window) {
  const lsr::Data part = *window(-1.5, 1.5).scan(half_turn());
  EXPECT_THAT(part.ranges, ElementsAre(89, 90, 91));
  EXPECT_NEAR(static_cast<double>(part.min_angle), geom::radians(-1), 1e-6);
  EXPECT_NEAR(static_cast<double>(part.max_angle), geom::radians(1), 1e-6);
  const lsr::Config config =
      window(-1.5, 1.5).config({static_cast<float>(geom::radians(-90)), static_cast<float>(geom::radians(90)),
                                static_cast<float>(geom::radians(1)), 200, 0, 1, 10});
  EXPECT_EQ(config.min_angle, part.min_angle);
  EXPECT_EQ(config.max_angle, part.max_angle);
  EXPECT_EQ(config.scanning_frequency, 10);
}

TEST(LaserCutter, keeps_all_beams_of_a_wider_window_and_none_of_one_beside) {
  EXPECT_EQ(window(-180, 180).scan(half_turn())->ranges, half_turn().ranges);
  EXPECT_THAT(window(91, 95).scan(half_turn())->ranges, IsEmpty());
  EXPECT_THAT(window(-100, -95).scan(half_turn())->ranges, IsEmpty());
  EXPECT_THAT(window(-10, 10).scan({-1, 1, 0.1f, 8, {}, {}, 1})->ranges, IsEmpty());
}

TEST(LaserCutter, has_nothing_of_a_scan_whose_angles_are_none) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(),
                  kInfinity = std::numeric_limits<float>::infinity();
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    EXPECT_FALSE(window(-10, 10).scan({bad, 1, 0.1f, 8, {1, 2}, {}, 1}));
    EXPECT_FALSE(window(-10, 10).scan({-1, 1, bad, 8, {1, 2}, {}, 1}));
  }
  EXPECT_FALSE(window(-10, 10).scan({-1, 1, 0, 8, {1, 2}, {}, 1}));
  EXPECT_EQ(window(-10, 10).config({-1, 1, 0, 8, 0, 1, 10}), (lsr::Config{-1, 1, 0, 8, 0, 1, 10}));
}

TEST(LaserCutter, has_fewer_intensities_if_the_laser_had_fewer) {
  lsr::Data scan = half_turn();
  scan.intensity.resize(90);
  EXPECT_THAT(window(-2, 3).scan(scan)->intensity, ElementsAre(88, 89));
}

TEST(LaserCutterDriver, passes_scans_cut_and_all_requests_on) {
  testing::DriverBench bench(
      "driver( name \"lasercutter\" provides [\"laser:1\"] requires [\"laser:0\"] min_angle -1 max_angle 1 )",
      {kWhole}, kCut);
  bench.says(kWhole, lsr::kDataScan, 5, half_turn());
  EXPECT_EQ(bench.site().recorder.published.back().timestamp, 5);
  const auto scans = bench.heard<lsr::Data>(lsr::kDataScan);
  ASSERT_EQ(scans.size(), 1u);
  EXPECT_THAT(scans[0].ranges, ElementsAre(89, 90, 91));
  bench.says(kWhole, lsr::kDataScanpose, 6, lsr::DataScanpose{half_turn(), {1, 2, 3}});
  const auto posed = bench.heard<lsr::DataScanpose>(lsr::kDataScanpose);
  ASSERT_EQ(posed.size(), 1u);
  EXPECT_THAT(posed[0].scan.ranges, ElementsAre(89, 90, 91));
  EXPECT_EQ(posed[0].pose.pa, 3);

  EXPECT_FALSE(bench.ask(lsr::kReqGetGeom)) << "the laser does not tell it";
  bench.answers(kWhole, lsr::kReqGetGeom, lsr::Geom{{0.1, 0, 0, 0, 0, 0}, {}});
  EXPECT_EQ(wire::decode<lsr::Geom>(*bench.ask(lsr::kReqGetGeom))->pose.px, 0.1);
  bench.answers(kWhole, lsr::kReqPower, lsr::PowerConfig{1});
  EXPECT_TRUE(bench.ask(lsr::kReqPower, wire::encode(lsr::PowerConfig{1})));
  EXPECT_EQ(bench.told().requests.back().body, wire::encode(lsr::PowerConfig{1}));
  const lsr::Data whole = half_turn();
  bench.answers(kWhole, lsr::kReqGetConfig,
                lsr::Config{whole.min_angle, whole.max_angle, whole.resolution, 200, 0, 1, 10});
  EXPECT_NEAR(static_cast<double>(wire::decode<lsr::Config>(*bench.ask(lsr::kReqGetConfig))->max_angle),
              geom::radians(1), 1e-6);
  device::Driver& driver = bench.site().driver(kCut);
  EXPECT_TRUE(driver.capable(bench.site().id(kCut), 3, lsr::kReqPower));
  EXPECT_FALSE(driver.capable(bench.site().id(kCut), 3, lsr::kReqGetId));
}

TEST(LaserCutterDriver, says_what_is_wrong_with_its_window) {
  EXPECT_THAT(testing::fault_of("driver( name \"dummy\" provides [\"laser:0\"] )\n"
                                "driver( name \"lasercutter\" provides [\"laser:1\"] requires [\"laser:0\"] "
                                "min_angle 10 max_angle -10 )"),
              HasSubstr("test.cfg:2: min_angle is not above max_angle"));
}

}  // namespace
}  // namespace playhouse::drivers
