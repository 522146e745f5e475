// Scans with the pose of their robot, which is between two poses as their times are.

#include "playhouse/drivers/scans/laserposeinterpolator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/drivers/testing/driver_bench.h"
#include "playhouse/geom/trig.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
namespace lsr = wire::laser;
namespace p2d = wire::position2d;

constexpr device::Address kScans{6665, lsr::kCode, 0}, kWheels{6665, p2d::kCode, 0},
    kPosed{6665, lsr::kCode, 1};

struct PoseBench : testing::DriverBench {
  explicit PoseBench(const std::string& options)
      : DriverBench(
            "driver( name \"laserposeinterpolator\" provides [\"laser:1\"] requires [\"laser:0\" "
            "\"position2d:0\"] " +
                options + " )",
            {kScans, kWheels}, kPosed) {}
  void stands(double time, const wire::Pose2d& pose) {
    says(kWheels, p2d::kDataState, time, p2d::Data{pose, {}, 0});
  }
  /// The poses of what is published of a scan.
  std::vector<wire::Pose2d> scans(double time) {
    says(kScans, lsr::kDataScan, time, lsr::Data{-1, 1, 1, 8, {1, 2, 3}, {}, 1});
    std::vector<wire::Pose2d> poses;
    for (const lsr::DataScanpose& each : heard<lsr::DataScanpose>(lsr::kDataScanpose)) {
      EXPECT_THAT(each.scan.ranges, ElementsAre(1, 2, 3));
      poses.push_back(each.pose);
    }
    return poses;
  }
};

TEST(LaserPoseInterpolator, tells_the_pose_of_the_time_of_a_scan) {
  PoseBench bench("");
  EXPECT_THAT(bench.scans(1), IsEmpty()) << "no pose is known yet";
  bench.stands(1, {0, 0, geom::radians(170)});
  bench.stands(2, {4, 2, geom::radians(-170)});
  const std::vector<wire::Pose2d> poses = bench.scans(1.25);
  ASSERT_EQ(poses.size(), 1u);
  EXPECT_DOUBLE_EQ(poses[0].px, 1);
  EXPECT_DOUBLE_EQ(poses[0].py, 0.5);
  EXPECT_NEAR(poses[0].pa, geom::radians(175), 1e-12) << "it turns the short way";
  EXPECT_THAT(bench.scans(3), ElementsAre(wire::Pose2d{4, 2, geom::radians(-170)}));
}

TEST(LaserPoseInterpolator, tells_the_newest_pose_without_interpolation) {
  PoseBench bench("interpolate 0");
  bench.stands(1, {0, 0, 0});
  bench.stands(2, {4, 2, 1});
  EXPECT_THAT(bench.scans(1.25), ElementsAre(wire::Pose2d{4, 2, 1}));
}

TEST(LaserPoseInterpolator, publishes_what_is_due) {
  PoseBench bench("send_all_scans 0 update_thresh [0.5 20] update_interval 10");
  bench.stands(1, {0, 0, 0});
  EXPECT_EQ(bench.scans(1).size(), 1u);
  EXPECT_EQ(bench.scans(2).size(), 0u);
  bench.stands(2, {0.3, 0.3, 0});
  EXPECT_EQ(bench.scans(2).size(), 0u) << "0.42 m";
  bench.stands(3, {0.3, 0.4, 0});
  EXPECT_EQ(bench.scans(3).size(), 1u) << "0.5 m";
  bench.stands(4, {0.3, 0.4, geom::radians(-21)});
  EXPECT_EQ(bench.scans(4).size(), 1u);
  EXPECT_EQ(bench.scans(13.9).size(), 0u);
  EXPECT_EQ(bench.scans(14).size(), 1u);
  bench.stands(2, {0.3, 0.4, 0});
  EXPECT_EQ(bench.scans(2).size(), 1u) << "time went back";
}

TEST(LaserPoseInterpolator, passes_over_poses_that_are_none) {
  PoseBench bench("");
  bench.stands(1, {1, 2, 0});
  bench.stands(2, {std::numeric_limits<double>::quiet_NaN(), 0, 0});
  EXPECT_THAT(bench.scans(2), ElementsAre(wire::Pose2d{1, 2, 0}));
}

}  // namespace
}  // namespace playhouse::drivers
