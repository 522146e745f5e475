// What clients may set of scans, and what the devices report then.

#include "playhouse/drivers/scan_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "playhouse/bridge/testing/one_device.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/ranger.h"
#include "playhouse/wire/generated/sonar.h"

namespace playhouse::drivers {
namespace {

using std::numbers::pi;
using ::testing::ElementsAre;
namespace lsr = wire::laser;
namespace rng = wire::ranger;

constexpr const char* kWorld = R"(
interval_sim 100
resolution 0.02
position( name "r0"
  ranger( name "scanner" sensor( range [0.1 8] fov 180 samples 7 ) )
  ranger( name "sonars" sensor( range [0 5] fov 15 ) sensor( range [0 9] fov 15 ) ) )
)";
constexpr double kStep = pi / 6;  // between the beams of the scanner

class ScanDevice : public testing::OneDevice {
 protected:
  ScanDevice() : OneDevice(kWorld) {
    measure("r0.scanner", 0, {1, 2, 3, 0.1f, 5, 6.03f, 8}, {1, 2, 300, 4, 5, 6, 0});
  }
  lsr::Config laser() { return reply<lsr::Config>(ask(lsr::kReqGetConfig)); }
  rng::Config ranger() { return reply<rng::Config>(ask(rng::kReqGetConfig)); }
  std::vector<float> scan() {
    still_.run(1);
    return last<lsr::Data>(lsr::kDataScan).ranges;
  }
};

TEST_F(ScanDevice, a_laser_reports_the_part_and_the_spacing_that_is_set_and_says_so) {
  open(lsr::kCode, "r0.scanner");
  lsr::Config wanted = laser();
  wanted.min_angle = -1.1f;  // between two beams
  wanted.max_angle = static_cast<float>(3 * kStep);
  wanted.resolution = static_cast<float>(2.5 * kStep);
  wanted.intensity = 0;
  const auto now = reply<lsr::Config>(ask_with(lsr::kReqSetConfig, wanted));
  EXPECT_NEAR(now.min_angle, -2 * kStep, 1e-6) << "the first beam within";
  EXPECT_NEAR(now.max_angle, 2 * kStep, 1e-6);
  EXPECT_NEAR(now.resolution, 2 * kStep, 1e-6) << "no coarser than wanted";
  EXPECT_EQ(now.intensity, 0);
  EXPECT_EQ(laser(), now);
  EXPECT_EQ(reply<lsr::Config>(ask_with(lsr::kReqSetConfig, now)), now) << "it is what it can do";
  EXPECT_THAT(scan(), ElementsAre(2, 0.1f, 6.03f));
  const auto data = last<lsr::Data>(lsr::kDataScan);
  EXPECT_EQ(data.min_angle, now.min_angle);
  EXPECT_EQ(data.max_angle, now.max_angle);
  EXPECT_EQ(data.resolution, now.resolution);
  EXPECT_TRUE(data.intensity.empty());
  reopen();
  EXPECT_EQ(scan().size(), 7u) << "until the last client closes it";
  EXPECT_EQ(last<lsr::Data>(lsr::kDataScan).intensity.size(), 7u);
}

TEST_F(ScanDevice, ranges_are_shortened_and_in_steps_and_a_scan_is_rarer) {
  open(lsr::kCode, "r0.scanner");
  lsr::Config wanted = laser();
  wanted.max_range = 5.5f;
  wanted.range_res = 0.5f;
  wanted.scanning_frequency = 3.4f;
  EXPECT_NEAR(reply<lsr::Config>(ask_with(lsr::kReqSetConfig, wanted)).scanning_frequency, 5, 1e-6)
      << "every second one: no rarer than wanted";
  still_.run(4);
  EXPECT_EQ(count(lsr::kDataScan), 2);
  const auto data = last<lsr::Data>(lsr::kDataScan);
  EXPECT_THAT(data.ranges, ElementsAre(1, 2, 3, 0.1f, 5, 5.5f, 5.5f));
  EXPECT_THAT(data.intensity, ElementsAre(1, 2, 255, 4, 5, 0, 0)) << "what is beyond is no hit";
  EXPECT_EQ(data.max_range, 5.5f);
}

TEST_F(ScanDevice, a_configuration_beyond_what_is_measured_is_refused_and_changes_nothing) {
  open(lsr::kCode, "r0.scanner");
  const lsr::Config usual = laser();
  const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
  const auto is_refused = [&](auto member, float value) {
    lsr::Config wanted = usual;
    wanted.*member = value;
    return !ask_with(lsr::kReqSetConfig, wanted).ack;
  };
  EXPECT_TRUE(is_refused(&lsr::Config::min_angle, -1.6f));
  EXPECT_TRUE(is_refused(&lsr::Config::min_angle, nan));
  EXPECT_TRUE(is_refused(&lsr::Config::max_angle, 1.6f));
  EXPECT_TRUE(is_refused(&lsr::Config::max_angle, -1.57f - 0.1f)) << "the last before the first";
  EXPECT_TRUE(is_refused(&lsr::Config::resolution, 0.5f)) << "finer";
  EXPECT_TRUE(is_refused(&lsr::Config::resolution, -1));
  EXPECT_TRUE(is_refused(&lsr::Config::resolution, infinity));
  EXPECT_TRUE(is_refused(&lsr::Config::max_range, 8.1f));
  EXPECT_TRUE(is_refused(&lsr::Config::max_range, 0.05f)) << "below the minimum";
  EXPECT_TRUE(is_refused(&lsr::Config::range_res, -0.1f));
  EXPECT_TRUE(is_refused(&lsr::Config::scanning_frequency, 11));
  EXPECT_TRUE(is_refused(&lsr::Config::scanning_frequency, -1));
  EXPECT_TRUE(is_refused(&lsr::Config::scanning_frequency, 1e-30f));
  lsr::Config between = usual;
  between.min_angle = 0.1f;
  between.max_angle = 0.2f;
  EXPECT_FALSE(ask_with(lsr::kReqSetConfig, between).ack) << "no beam goes there";
  EXPECT_FALSE(ask(lsr::kReqSetConfig).ack);
  EXPECT_EQ(laser(), usual);
}

TEST_F(ScanDevice, zeros_keep_what_is_and_old_programs_have_hundredths_of_a_degree) {
  open(lsr::kCode, "r0.scanner");
  const lsr::Config old{static_cast<float>(-pi / 2), static_cast<float>(pi / 2), 6000, 0, 1, 1, 0};
  const auto now = reply<lsr::Config>(ask_with(lsr::kReqSetConfig, old));
  EXPECT_NEAR(now.resolution, 2 * kStep, 1e-6);
  EXPECT_EQ(now.max_range, 8);
  EXPECT_EQ(now.range_res, 1);
  EXPECT_NEAR(now.scanning_frequency, 10, 1e-6);
}

TEST_F(ScanDevice, a_laser_has_a_number_and_filters) {
  open(lsr::kCode, "r0.scanner");
  EXPECT_EQ(reply<lsr::GetIdConfig>(ask_with(lsr::kReqGetId, lsr::GetIdConfig{})).serial_number,
            still_.world().id(still_.world().find("r0.scanner")).value);
  const auto filter = [&](std::int32_t type, std::vector<float> parameters) {
    const lsr::SetFilterConfig wanted{static_cast<std::uint8_t>(type), std::move(parameters)};
    return ask_with(lsr::kReqSetFilter, wanted).ack;
  };
  EXPECT_TRUE(filter(lsr::kFilterMedian, {}));
  EXPECT_THAT(scan(), ElementsAre(1, 2, 2, 3, 5, 6.03f, 8));
  EXPECT_TRUE(filter(lsr::kFilterMedian, {0}));
  EXPECT_TRUE(filter(lsr::kFilterRange, {1.5f, 5}));
  EXPECT_THAT(scan(), ElementsAre(8, 2, 3, 8, 5, 8, 8));
  EXPECT_THAT(last<lsr::Data>(lsr::kDataScan).intensity, ElementsAre(0, 2, 255, 0, 5, 0, 0));
  EXPECT_TRUE(filter(lsr::kFilterRange, {}));
  EXPECT_TRUE(filter(lsr::kFilterMean, {2}));
  EXPECT_EQ(scan()[0], 1);
  measure("r0.scanner", 0, {4}, {1});
  EXPECT_EQ(scan()[0], 2.5f);
  EXPECT_EQ(scan()[0], 4);
  EXPECT_TRUE(filter(lsr::kFilterEdge, {1}));
  EXPECT_FALSE(filter(lsr::kFilterMean, {11}));
  EXPECT_FALSE(filter(lsr::kFilterMean, {1.5f}));
  EXPECT_FALSE(filter(lsr::kFilterMean, {}));
  EXPECT_FALSE(filter(lsr::kFilterRange, {5, 1}));
  EXPECT_FALSE(filter(lsr::kFilterRange, {std::nanf(""), 1}));
  EXPECT_FALSE(filter(9, {}));
  EXPECT_TRUE(filter(lsr::kFilterMean, {1}));
}

TEST_F(ScanDevice, without_power_there_are_no_scans) {
  open(lsr::kCode, "r0.scanner");
  EXPECT_TRUE(ask_with(lsr::kReqPower, lsr::PowerConfig{0}).ack);
  still_.run(2);
  EXPECT_EQ(count(lsr::kDataScan), 0);
  EXPECT_TRUE(ask_with(lsr::kReqPower, lsr::PowerConfig{1}).ack);
  still_.run(2);
  EXPECT_EQ(count(lsr::kDataScan), 2);
}

TEST_F(ScanDevice, a_ranger_stamps_the_first_scan_with_another_configuration) {
  open(rng::kCode, "r0.scanner");
  still_.run(1);
  EXPECT_EQ(count(rng::kDataRangestamped), 0);
  rng::Config wanted = ranger();
  wanted.min_angle = 0;
  wanted.min_range = 1.5;
  const auto now = reply<rng::Config>(ask_with(rng::kReqSetConfig, wanted));
  EXPECT_EQ(ranger(), now);
  still_.run(2);
  EXPECT_EQ(count(rng::kDataRangestamped), 1);
  EXPECT_EQ(count(rng::kDataIntnsstamped), 1);
  const auto stamped = last<rng::DataRangestamped>(rng::kDataRangestamped);
  EXPECT_EQ(stamped.config, now);
  EXPECT_EQ(stamped.have_geom, 1);
  EXPECT_EQ(stamped.geom, reply<rng::Geom>(ask(rng::kReqGetGeom)));
  const auto ranges = last<rng::DataRange>(rng::kDataRange).ranges;
  ASSERT_EQ(ranges.size(), 4u);
  EXPECT_EQ(stamped.data.ranges, ranges);
  EXPECT_EQ(ranges[0], 1.5) << "too near";
  EXPECT_EQ(ranges[1], 5);
  EXPECT_TRUE(ask_with(rng::kReqIntns, rng::IntnsConfig{0}).ack);
  const auto before = count(rng::kDataIntns);
  still_.run(1);
  EXPECT_EQ(count(rng::kDataIntns), before);
  reopen();
  still_.run(1);
  EXPECT_EQ(last<rng::DataRange>(rng::kDataRange).ranges.size(), 7u);
  EXPECT_EQ(count(rng::kDataRangestamped), 2) << "of the intensities, and none after the last close";
}

TEST_F(ScanDevice, an_array_keeps_its_directions_and_the_ranges_of_each_sensor) {
  open(rng::kCode, "r0.sonars");
  measure("r0.sonars", 0, {4.26f}, {1});
  measure("r0.sonars", 1, {7.24f}, {1});
  rng::Config wanted = ranger();
  wanted.max_angle *= 0.5;
  EXPECT_FALSE(ask_with(rng::kReqSetConfig, wanted).ack);
  wanted = ranger();
  wanted.range_res = 0.5;
  EXPECT_TRUE(ask_with(rng::kReqSetConfig, wanted).ack);
  still_.run(1);
  EXPECT_THAT(last<rng::DataRange>(rng::kDataRange).ranges, ElementsAre(4.5, 7));
  wanted.max_range = 4;
  EXPECT_TRUE(ask_with(rng::kReqSetConfig, wanted).ack);
  still_.run(1);
  EXPECT_THAT(last<rng::DataRange>(rng::kDataRange).ranges, ElementsAre(4, 4));
  EXPECT_THAT(last<rng::DataIntns>(rng::kDataIntns).intensities, ElementsAre(0, 0));
}

TEST_F(ScanDevice, a_sonar_can_be_off) {
  open(wire::sonar::kCode, "r0.sonars");
  EXPECT_TRUE(ask_with(wire::sonar::kReqPower, wire::sonar::PowerConfig{0}).ack);
  still_.run(1);
  EXPECT_EQ(count(wire::sonar::kDataRanges), 0);
  EXPECT_FALSE(ask(wire::sonar::kReqPower).ack);
  reopen();
  still_.run(1);
  EXPECT_EQ(count(wire::sonar::kDataRanges), 1);
}

TEST_F(ScanDevice, a_property_is_the_same_setting) {
  open(lsr::kCode, "r0.scanner");
  EXPECT_EQ(number("max_range"), 8);
  EXPECT_TRUE(set_number("max_range", 4));
  EXPECT_EQ(laser().max_range, 4);
  EXPECT_EQ(scan()[6], 4);
  EXPECT_FALSE(set_number("max_range", 9));
  EXPECT_FALSE(set_number("no such name", 9));
  EXPECT_EQ(number("max_range"), 4);
}

}  // namespace
}  // namespace playhouse::drivers
