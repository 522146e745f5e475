// Scans of a laser, a ranger and sonars, from devices that tell where they look well or badly.

#include "playhouse/drivers/algorithm/scan_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "playhouse/device/fake_device.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/sonar.h"

namespace playhouse::drivers {
namespace {

using geom::radians;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
namespace lsr = wire::laser;
namespace rng = wire::ranger;
namespace snr = wire::sonar;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
using Body = std::vector<std::byte>;

/// Answers requests with what a test gives; NACK if there is nothing.
struct Teller final : device::Driver {
  std::string_view name() const override { return "teller"; }
  Result<void> start(device::DeviceId) override { return {}; }
  void stop(device::DeviceId) override {}
  device::Taken command(const device::Message&) override { return device::Taken::kNo; }
  void request(const device::Message& message, device::Replier replier) override {
    if (const auto found = told.find(message.subtype); found != told.end()) replier.ack(found->second);
  }
  bool capable(device::DeviceId, std::uint8_t, std::uint8_t) const override { return true; }

  std::map<std::uint8_t, Body> told;  // by subtype of the request
};

/// A reader of one device.
class Reading {
 public:
  Reading(ScanInterface interf, std::map<std::uint8_t, Body> told) : reader_(client_, 0, interf) {
    teller_.told = std::move(told);
    flow_.pass_to(nowhere_);
    client_.use(0, {7}, teller_);
    client_.join(flow_);
    EXPECT_TRUE(client_.open());
    reader_.ask([this](const std::string& why) { this->why = why; });
  }
  void publish(std::uint8_t subtype, const Body& body) { flow_.publish({{{7}, subtype, 1.5, body}}); }
  std::optional<RangeScan> scan_of(std::uint8_t subtype, const Body& body) {
    publish(subtype, body);
    EXPECT_TRUE(reader_.take());
    EXPECT_FALSE(reader_.take()) << "it is no news any more";
    EXPECT_EQ(reader_.time(), 1.5);
    return reader_.scan();
  }
  ScanReader& reader() { return reader_; }

  std::string why;

 private:
  struct Nowhere final : device::Publisher {
    void publish(std::vector<device::Publication>) override {}
  };
  device::FakeDevices devices_;
  Teller teller_;
  Nowhere nowhere_;
  device::DataFlow flow_;
  device::DeviceClient client_{devices_, teller_, 1};
  ScanReader reader_;
};

Reading of_laser(const wire::Pose3d& pose) {
  return {ScanInterface::kLaser, {{lsr::kReqGetGeom, wire::encode(lsr::Geom{pose, {}})}}};
}
Reading of_sonars(const std::vector<wire::Pose3d>& poses) {
  return {ScanInterface::kSonar, {{snr::kReqGetGeom, wire::encode(snr::Geom{poses})}}};
}
std::map<std::uint8_t, Body> ranger(const rng::Geom& geom, const std::optional<rng::Config>& config) {
  std::map<std::uint8_t, Body> told{{rng::kReqGetGeom, wire::encode(geom)}};
  if (config) told[rng::kReqGetConfig] = wire::encode(*config);
  return told;
}
Body ranges(std::vector<double> values) {
  return wire::encode(rng::DataRange{std::move(values)});
}

/// Where beams end, in R, to the millimetre.
std::vector<std::pair<double, double>> ends(const RangeScan& scan) {
  std::vector<std::pair<double, double>> ends;
  const auto rounded = [](double value) { return std::round(1000 * value) / 1000 + 0.0; };
  for (std::size_t i = 0; i < scan.ranges.size(); ++i)
    ends.emplace_back(rounded(end_of_beam(scan, i).x), rounded(end_of_beam(scan, i).y));
  return ends;
}

/// From a place 0.1 m ahead: 1 m to the right, 2 m ahead, 3 m to the left.
const auto kEnds = ElementsAre(std::pair(0.1, -1.0), std::pair(2.1, 0.0), std::pair(0.1, 3.0));
constexpr wire::Pose3d kAhead{0.1, 0, 0, 0, 0, 0};

TEST(ScanReader, beams_end_at_the_same_points_whatever_interface_tells_them) {
  Reading laser = of_laser(kAhead);
  lsr::Data data;
  data.min_angle = static_cast<float>(radians(-90));
  data.resolution = static_cast<float>(radians(90));
  data.max_range = 8;
  data.ranges = {1, 2, 3};
  const std::optional<RangeScan> by_laser = laser.scan_of(lsr::kDataScan, wire::encode(data));
  ASSERT_TRUE(by_laser);
  EXPECT_THAT(ends(*by_laser), kEnds);
  EXPECT_EQ(by_laser->max_range, 8);
  EXPECT_FALSE(by_laser->is_ring());

  rng::Config config;
  config.min_angle = radians(-90);
  config.max_angle = radians(90);
  config.angular_res = radians(90);
  config.max_range = 8;
  Reading scanner(ScanInterface::kRanger, ranger({kAhead, {}, {{}}, {}}, config));
  const std::optional<RangeScan> by_scanner = scanner.scan_of(rng::kDataRange, ranges({1, 2, 3}));
  ASSERT_TRUE(by_scanner);
  EXPECT_THAT(ends(*by_scanner), kEnds);
  EXPECT_EQ(by_scanner->max_range, 8);
  EXPECT_FALSE(by_scanner->is_ring());

  const std::vector<wire::Pose3d> turned = {{0, 0, 0, 0, 0, radians(-90)}, {}, {0, 0, 0, 0, 0, radians(90)}};
  Reading ring(ScanInterface::kRanger, ranger({kAhead, {}, turned, {}}, config));
  const std::optional<RangeScan> by_ring = ring.scan_of(rng::kDataRange, ranges({1, 2, 3}));
  ASSERT_TRUE(by_ring);
  EXPECT_THAT(ends(*by_ring), kEnds);
  EXPECT_EQ(by_ring->max_range, 8);
  EXPECT_TRUE(by_ring->is_ring());

  Reading sonars =
      of_sonars({{0.1, 0, 0, 0, 0, radians(-90)}, {0.1, 0, 0, 0, 0, 0}, {0.1, 0, 0, 0, 0, radians(90)}});
  const std::optional<RangeScan> by_sonars =
      sonars.scan_of(snr::kDataRanges, wire::encode(snr::Data{{1, 2, 3}}));
  ASSERT_TRUE(by_sonars);
  EXPECT_THAT(ends(*by_sonars), kEnds);
  EXPECT_EQ(by_sonars->max_range, std::numeric_limits<double>::infinity()) << "sonars do not tell it";
  EXPECT_TRUE(by_sonars->is_ring());
}

TEST(ScanReader, elements_that_scan_have_so_many_beams_each) {
  rng::Config config;
  config.min_angle = radians(-90);
  config.max_angle = radians(90);
  Reading two(ScanInterface::kRanger, ranger({{}, {}, {{}, {0, 0, 0, 0, 0, radians(180)}}, {}}, config));
  const std::optional<RangeScan> scan = two.scan_of(rng::kDataRange, ranges({1, 2, 3, 4}));
  ASSERT_TRUE(scan);
  EXPECT_TRUE(is_usable(*scan));
  EXPECT_THAT(ends(*scan), ElementsAre(std::pair(0.0, -1.0), std::pair(0.0, 2.0), std::pair(0.0, 3.0),
                                       std::pair(0.0, -4.0)))
      << "without a resolution beams are spread over the field of view";
  EXPECT_FALSE(is_usable(*two.scan_of(rng::kDataRange, ranges({1, 2, 3})))) << "two elements, three ranges";
}

TEST(ScanReader, follows_what_a_ranger_says_has_changed) {
  rng::Config config;
  config.min_angle = radians(-90);
  config.angular_res = radians(90);
  Reading scanner(ScanInterface::kRanger, ranger({kAhead, {}, {{}}, {}}, config));
  config.min_angle = 0;
  scanner.publish(rng::kDataRangestamped,
                  wire::encode(rng::DataRangestamped{{{1, 2}}, 1, {{}, {}, {}, {}}, 1, config}));
  const std::optional<RangeScan> scan = scanner.scan_of(rng::kDataRange, ranges({1, 2}));
  ASSERT_TRUE(scan);
  EXPECT_THAT(ends(*scan), ElementsAre(std::pair(1.0, 0.0), std::pair(0.0, 2.0)));
}

TEST(ScanReader, a_cone_reaches_half_way_to_the_next_one_and_15_degrees_at_most) {
  std::vector<double> widths;
  for (const ScanEye& eye : ring_of({{0, 0, 0, radians(90)},
                                     {-0.2, 0, 0, radians(90)},
                                     {0, 0, 0, radians(50)},
                                     {0, 0, 0, radians(30)},
                                     {0, 0, 0, radians(-175)}}))
    widths.push_back(std::round(1000 * geom::degrees(eye.half_width)) / 1000);
  EXPECT_THAT(widths, ElementsAre(15, 15, 10, 10, 15));
}

TEST(ScanReader, what_one_sonar_lacks_the_others_do_without) {
  Reading sonars = of_sonars({{}, {}});
  EXPECT_EQ(sonars.scan_of(snr::kDataRanges, wire::encode(snr::Data{{1, 2, 3}}))->ranges.size(), 2u);
  EXPECT_EQ(sonars.scan_of(snr::kDataRanges, wire::encode(snr::Data{{1}}))->eyes.size(), 1u);
  EXPECT_FALSE(is_usable(*sonars.scan_of(snr::kDataRanges, wire::encode(snr::Data{}))));
}

TEST(ScanReader, says_what_its_device_does_not_tell) {
  EXPECT_EQ(Reading(ScanInterface::kLaser, {}).why, "its laser does not tell its place");
  EXPECT_EQ(Reading(ScanInterface::kLaser, {{lsr::kReqGetGeom, Body(3)}}).why,
            "its laser does not tell its place");
  EXPECT_EQ(of_laser({kNan, 0, 0, 0, 0, 0}).why, "its laser does not tell its place");
  const std::string sonars = "its sonars do not tell their places";
  EXPECT_EQ(Reading(ScanInterface::kSonar, {}).why, sonars);
  EXPECT_EQ(of_sonars({}).why, sonars);
  EXPECT_EQ(of_sonars({{kNan, 0, 0, 0, 0, 0}, {2, 0, 0, 0, 0, 0}}).why, sonars)
      << "lest ranges are taken for those of others";
  EXPECT_EQ(of_sonars({{1, 0, 0, 0, 0, 0}, {2, 1e10, 0, 0, 0, 0}}).why, sonars);
  EXPECT_THAT(of_sonars(std::vector<wire::Pose3d>(1001)).why, HasSubstr("1000 at most"));
  const std::string places = "its ranger does not tell its places";
  EXPECT_EQ(Reading(ScanInterface::kRanger, {}).why, places);
  EXPECT_EQ(Reading(ScanInterface::kRanger, ranger({{kNan, 0, 0, 0, 0, 0}, {}, {}, {}}, {})).why, places);
  EXPECT_EQ(Reading(ScanInterface::kRanger, ranger({{}, {}, {{kNan, 0, 0, 0, 0, 0}}, {}}, {})).why, places);
  EXPECT_EQ(Reading(ScanInterface::kRanger, ranger({{}, {}, {{}}, {}}, {})).why,
            "its ranger does not tell its angles");
  Reading ring(ScanInterface::kRanger, ranger({{}, {}, {{}, {}}, {}}, {}));
  EXPECT_EQ(ring.why, "") << "each element has a direction";
  EXPECT_TRUE(ring.reader().is_ready());
  EXPECT_FALSE(ring.scan_of(rng::kDataRange, ranges({1, 2, 3, 4})))
      << "but beams within an element have none";
}

TEST(ScanReader, has_no_scan_before_it_is_ready_and_of_what_is_none) {
  Reading laser(ScanInterface::kLaser, {});
  EXPECT_FALSE(laser.reader().is_ready());
  EXPECT_FALSE(laser.scan_of(lsr::kDataScan, wire::encode(lsr::Data{})));
  EXPECT_FALSE(of_laser({}).scan_of(lsr::kDataScan, Body(3)));
  EXPECT_FALSE(of_sonars({{}}).scan_of(snr::kDataRanges, Body(3)));
}

TEST(RangeScan, without_beams_or_with_invalid_angles_cannot_be_used) {
  const RangeScan good{{ScanEye{}}, {1, 2}, 0, 1};
  EXPECT_TRUE(is_usable(good));
  EXPECT_FALSE(is_usable(RangeScan{}));
  for (const double bad : {0.0, -1.0, 8.0, kNan, 1e300}) {
    RangeScan scan = good;
    scan.angle_step = bad;
    EXPECT_FALSE(is_usable(scan)) << bad;
  }
  RangeScan scan = good;
  scan.first_angle = kNan;
  EXPECT_FALSE(is_usable(scan));
  EXPECT_TRUE(is_usable(RangeScan{{ScanEye{}}, {1}, 0, 0})) << "one beam needs no step";
}

}  // namespace
}  // namespace playhouse::drivers
