#include "playhouse/drivers/motion/lasersafe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "playhouse/drivers/testing/driver_bench.h"
#include "playhouse/geom/trig.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
namespace lsr = wire::laser;
namespace p2d = wire::position2d;

constexpr device::Address kWheels{6665, p2d::kCode, 0}, kLaser{6665, lsr::kCode, 0},
    kGuarded{6665, p2d::kCode, 1};
constexpr int kBeams = 181;

/// Free for 8 m but for a point, in the laser's frame.
lsr::Data scan_of(double x, double y) {
  lsr::Data scan{static_cast<float>(geom::radians(-90)),
                 static_cast<float>(geom::radians(90)),
                 static_cast<float>(geom::radians(1)),
                 8,
                 std::vector<float>(kBeams, 8),
                 {},
                 1};
  const auto beam = static_cast<std::size_t>(std::lround(geom::degrees(geom::atan2(y, x)))) + 90;
  scan.ranges[beam] = static_cast<float>(std::sqrt(x * x + y * y));
  return scan;
}

LaserSafeOptions each_beam() {
  LaserSafeOptions options;
  options.step = 1;
  return options;
}

TEST(IsBlocked, by_what_is_in_the_box) {
  EXPECT_TRUE(is_blocked(each_beam(), 0.2, scan_of(0.39, 0)));
  EXPECT_FALSE(is_blocked(each_beam(), 0.2, scan_of(0.41, 0)));
  EXPECT_TRUE(is_blocked(each_beam(), 0.2, scan_of(0.39, 0.18)));
  EXPECT_FALSE(is_blocked(each_beam(), 0.2, scan_of(0.2, 0.25)));
}

TEST(IsBlocked, by_what_is_near_in_any_direction_without_a_box) {
  LaserSafeOptions options = each_beam();
  options.is_box = false;
  EXPECT_TRUE(is_blocked(options, 0, scan_of(0.2, 0.25)));
  EXPECT_FALSE(is_blocked(options, 0, scan_of(0.3, 0.3)));
}

TEST(IsBlocked, by_the_beams_that_count) {
  LaserSafeOptions options = each_beam();
  options.step = 5;
  EXPECT_TRUE(is_blocked(options, 0.2, scan_of(0.3, 0)));
  EXPECT_FALSE(is_blocked(options, 0.2, scan_of(0.3 * std::cos(0.035), 0.3 * std::sin(0.035))))
      << "2 degrees";
}

TEST(IsBlocked, not_by_what_is_no_range) {
  lsr::Data scan = scan_of(0.3, 0);
  for (const float none :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1.0f}) {
    scan.ranges[90] = none;
    EXPECT_FALSE(is_blocked(each_beam(), 0.2, scan));
  }
  scan.ranges[90] = 1;
  scan.resolution = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(is_blocked(each_beam(), 0.2, scan)) << "it may be anywhere";
  EXPECT_FALSE(is_blocked(each_beam(), 0.2, lsr::Data{}));
}

struct SafeBench : testing::DriverBench {
  explicit SafeBench(const std::string& options)
      : DriverBench(
            "driver( name \"lasersafe\" provides [\"position2d:1\"] requires [\"position2d:0\" \"laser:0\"] "
            "step 1 " +
                options + " )",
            {kWheels, kLaser}, kGuarded) {}
  void see(double x) { says(kLaser, lsr::kDataScan, 1, scan_of(x, 0)); }
  device::Taken drive(double speed) { return command(p2d::kCmdVel, p2d::CmdVel{{speed, 0, 0}, 1}); }
  std::vector<double> told_speeds() {
    std::vector<double> speeds;
    for (const p2d::CmdVel& command : commanded<p2d::CmdVel>(kWheels, p2d::kCmdVel))
      speeds.push_back(command.vel.px);
    return speeds;
  }
};

TEST(LaserSafe, stops_before_an_obstacle_and_lets_the_robot_back_away) {
  SafeBench bench("boxwidth 0.4");
  EXPECT_EQ(bench.drive(0.3), device::Taken::kNo) << "it has seen nothing yet";
  bench.see(2);
  EXPECT_EQ(bench.drive(0.3), device::Taken::kLatest);
  EXPECT_THAT(bench.told_speeds(), ElementsAre(0.3));
  bench.see(0.3);
  EXPECT_THAT(bench.told_speeds(), ElementsAre(0));
  EXPECT_EQ(bench.drive(0.3), device::Taken::kNo);
  EXPECT_EQ(bench.command(p2d::kCmdPos, p2d::CmdPos{{-3, 0, 0}, {}, 1}), device::Taken::kNo);
  EXPECT_EQ(bench.drive(-0.3), device::Taken::kLatest);
  bench.see(0.35);
  EXPECT_THAT(bench.told_speeds(), ElementsAre(-0.3)) << "it goes on backing away";
  bench.see(0.5);
  EXPECT_EQ(bench.drive(0.3), device::Taken::kLatest);
}

TEST(LaserSafe, of_a_laser_that_looks_back_keeps_it_from_backing) {
  SafeBench bench("boxwidth 0.4 forward 0");
  bench.see(0.3);
  EXPECT_EQ(bench.drive(-0.3), device::Taken::kNo);
  EXPECT_EQ(bench.drive(0.3), device::Taken::kLatest);
}

TEST(LaserSafe, ranges_are_means_of_the_last_scans) {
  SafeBench bench("boxwidth 0.4 history 3");
  for (int i = 0; i < 3; ++i) bench.see(0.9);
  EXPECT_EQ(bench.drive(0.3), device::Taken::kLatest);
  bench.see(0.1);  // (0.9 + 0.9 + 0.1) / 3 = 0.63
  EXPECT_THAT(bench.told_speeds(), ElementsAre(0.3));
  bench.see(0.1);  // 0.37
  EXPECT_THAT(bench.told_speeds(), ElementsAre(0));
}

TEST(LaserSafe, is_as_wide_as_the_robot_and_a_tenth) {
  SafeBench bench("");
  bench.see(2);
  EXPECT_EQ(bench.drive(0.3), device::Taken::kNo) << "it does not tell its width";
  bench.close();
  bench.answers(kWheels, p2d::kReqGetGeom, p2d::Geom{{}, {0.6, 0.5, 0.2}});
  ASSERT_TRUE(bench.open());
  bench.says(kLaser, lsr::kDataScan, 1, scan_of(0.2, 0.32));
  EXPECT_EQ(bench.drive(0.3), device::Taken::kNo);
  bench.says(kLaser, lsr::kDataScan, 1, scan_of(0.2, 0.34));
  EXPECT_EQ(bench.drive(0.3), device::Taken::kLatest);
}

TEST(LaserSafe, says_what_is_wrong_with_its_options) {
  const auto fault = [](const std::string& options) {
    return testing::fault_of(
        "driver( name \"dummy\" provides [\"position2d:0\" \"laser:0\"] )\n"
        "driver( name \"lasersafe\" provides [\"position2d:1\"] requires [\"position2d:0\" \"laser:0\"] " +
        options + " )");
  };
  EXPECT_EQ(fault("safedistance -1"), "test.cfg:2: safedistance is 0 at least");
  EXPECT_EQ(fault("step 0"), "test.cfg:2: step is from 1 to 1000");
  EXPECT_EQ(fault("history 0"), "test.cfg:2: history is from 1 to 100");
}

}  // namespace
}  // namespace playhouse::drivers
