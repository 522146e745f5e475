// A laser as a ranger: what it says, and what becomes of each request.

#include "playhouse/drivers/scans/lasertoranger.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/drivers/testing/driver_bench.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
namespace lsr = wire::laser;
namespace rng = wire::ranger;

constexpr device::Address kLaser{6665, lsr::kCode, 0}, kRanger{6665, rng::kCode, 0};

class LaserToRangerTest : public ::testing::Test {
 protected:
  LaserToRangerTest()
      : bench("driver( name \"lasertoranger\" provides [\"ranger:0\"] requires [\"laser:0\"] )", {kLaser},
              kRanger) {
    bench.answers(kLaser, lsr::kReqGetConfig, lsr::Config{-1, 1, 0.5f, 8, 0.25f, 1, 10});
    bench.answers(kLaser, lsr::kReqSetConfig, lsr::Config{-0.5f, 0.5f, 0.25f, 4, 0.5f, 0, 5});
  }
  lsr::Config told() { return *wire::decode<lsr::Config>(bench.told().requests.back().body); }

  testing::DriverBench bench;
};

TEST_F(LaserToRangerTest, publishes_ranges_and_intensities_of_each_scan) {
  bench.says(kLaser, lsr::kDataScan, 2.5, lsr::Data{-1, 1, 0.5f, 8, {1, 2, 3, 4, 5}, {0, 1, 2, 3, 255}, 1});
  ASSERT_EQ(bench.site().recorder.published.back().timestamp, 2.5);
  EXPECT_THAT(bench.heard<rng::DataRange>(rng::kDataRange).at(0).ranges, ElementsAre(1, 2, 3, 4, 5));
  bench.says(kLaser, lsr::kDataScan, 2.5, lsr::Data{-1, 1, 0.5f, 8, {1, 2, 3, 4, 5}, {0, 1, 2, 3, 255}, 2});
  EXPECT_THAT(bench.heard<rng::DataIntns>(rng::kDataIntns).at(0).intensities, ElementsAre(0, 1, 2, 3, 255));
}

TEST_F(LaserToRangerTest, a_laser_without_intensities_has_none_and_one_with_poses_has_ranges) {
  bench.says(kLaser, lsr::kDataScan, 1, lsr::Data{-1, 1, 1, 8, {1, 2, 3}, {}, 1});
  EXPECT_THAT(bench.heard<rng::DataIntns>(rng::kDataIntns), IsEmpty());
  bench.says(kLaser, lsr::kDataScanpose, 1, lsr::DataScanpose{{-1, 1, 1, 8, {4, 5, 6}, {}, 1}, {}});
  EXPECT_THAT(bench.heard<rng::DataRange>(rng::kDataRange).at(0).ranges, ElementsAre(4, 5, 6));
  bench.says(kLaser, lsr::kDataScan, 1, lsr::Data{});
  EXPECT_THAT(bench.heard<rng::DataRange>(rng::kDataRange).at(0).ranges, IsEmpty());
}

TEST_F(LaserToRangerTest, tells_where_it_is_and_where_it_looks) {
  EXPECT_FALSE(bench.ask(rng::kReqGetGeom)) << "the laser does not tell it";
  const wire::Pose3d place{0.1, 0.2, 0.3, 0, 0, 0.5};
  bench.answers(kLaser, lsr::kReqGetGeom, lsr::Geom{place, {0.15, 0.16, 0.17}});
  const rng::Geom geom = *wire::decode<rng::Geom>(*bench.ask(rng::kReqGetGeom));
  EXPECT_EQ(geom.pose, place);
  EXPECT_THAT(geom.element_poses, ElementsAre(wire::Pose3d{}));
  EXPECT_THAT(geom.element_sizes, ElementsAre(wire::Bbox3d{0.15, 0.16, 0.17}));
  EXPECT_EQ(*wire::decode<rng::Config>(*bench.ask(rng::kReqGetConfig)),
            (rng::Config{-1, 1, 0.5, 0, 8, 0.25, 10}));
}

TEST_F(LaserToRangerTest, sets_the_laser_as_the_ranger_is_set) {
  const rng::Config wanted{-0.5, 0.5, 0.25, 0, 4, 0.5, 5};
  EXPECT_EQ(*wire::decode<rng::Config>(*bench.ask(rng::kReqSetConfig, wire::encode(wanted))), wanted);
  EXPECT_EQ(told(), (lsr::Config{-0.5f, 0.5f, 0.25f, 4, 0.5f, 1, 5})) << "intensities are another setting";
  EXPECT_EQ(
      wire::decode<rng::IntnsConfig>(*bench.ask(rng::kReqIntns, wire::encode(rng::IntnsConfig{0})))->state,
      0);
  EXPECT_EQ(told(), (lsr::Config{-1, 1, 0.5f, 8, 0.25f, 0, 10}));
  EXPECT_FALSE(bench.ask(rng::kReqPower, wire::encode(rng::PowerConfig{1}))) << "the laser has no switch";
  bench.answers(kLaser, lsr::kReqPower, lsr::PowerConfig{1});
  EXPECT_TRUE(bench.ask(rng::kReqPower, wire::encode(rng::PowerConfig{1})));
  EXPECT_FALSE(bench.ask(rng::kReqSetConfig, {}));
  EXPECT_FALSE(bench.ask(rng::kReqIntns, {}));
}

TEST(LaserToRanger, needs_a_laser) {
  EXPECT_THAT(
      testing::fault_of("driver( name \"lasertoranger\" provides [\"ranger:0\"] requires [\"sonar:0\"] )"),
      HasSubstr("test.cfg:1: driver \"lasertoranger\" requires one laser, e.g. [\"laser:0\"]"));
}

}  // namespace
}  // namespace playhouse::drivers
