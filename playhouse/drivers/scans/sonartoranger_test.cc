#include "playhouse/drivers/scans/sonartoranger.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/drivers/testing/driver_bench.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
namespace rng = wire::ranger;
namespace snr = wire::sonar;

constexpr device::Address kSonars{6665, snr::kCode, 0}, kRanger{6665, rng::kCode, 0};

TEST(SonarToRanger, is_a_ranger_with_an_element_for_each_sonar) {
  testing::DriverBench bench(
      "driver( name \"sonartoranger\" provides [\"ranger:0\"] requires [\"sonar:0\"] )", {kSonars}, kRanger);
  bench.says(kSonars, snr::kDataRanges, 3, snr::Data{{1.5f, 2.5f}});
  ASSERT_EQ(bench.site().recorder.published.back().timestamp, 3);
  EXPECT_THAT(bench.heard<rng::DataRange>(rng::kDataRange).at(0).ranges, ElementsAre(1.5, 2.5));
  const wire::Pose3d right{0.1, -0.2, 0, 0, 0, -1}, left{0.1, 0.2, 0, 0, 0, 1};
  bench.answers(kSonars, snr::kReqGetGeom, snr::Geom{{right, left}});
  const rng::Geom geom = *wire::decode<rng::Geom>(*bench.ask(rng::kReqGetGeom));
  EXPECT_EQ(geom.pose, wire::Pose3d{});
  EXPECT_THAT(geom.element_poses, ElementsAre(right, left));
  EXPECT_EQ(geom.element_sizes.size(), 2u);
  EXPECT_FALSE(bench.ask(rng::kReqGetConfig)) << "sonars have none";
  bench.answers(kSonars, snr::kReqPower, snr::PowerConfig{0});
  EXPECT_TRUE(bench.ask(rng::kReqPower, wire::encode(rng::PowerConfig{0})));
}

}  // namespace
}  // namespace playhouse::drivers
