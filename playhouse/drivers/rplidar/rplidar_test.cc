// The driver against a script that says what a lidar said to the maker's host, and against the emulator.

#include "playhouse/drivers/rplidar/rplidar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "playhouse/drivers/hardware/testing_hardware.h"
#include "playhouse/drivers/rplidar/rplidar_frames.h"
#include "playhouse/wire/generated/laser.h"

namespace playhouse::drivers {
namespace {

namespace lsr = wire::laser;
using std::numbers::pi;
using testing::FarEnd;
using testing::from_hex;
using testing::HardwareTest;
using testing::to_hex;

constexpr net::SerialSettings kUsualSerial{.baud = 115200};

std::string lidar_section(const std::string& more = "") {
  return R"(driver( name "rplidar" port "/dev/lidar" provides ["laser:1" "ranger:1"] )" + more + " )";
}

class RplidarScript : public HardwareTest {
 protected:
  void begin(const std::string& more = "", const net::SerialSettings& serial = kUsualSerial) {
    lidar = std::make_unique<FarEnd>(network_, "/dev/lidar", serial);
    ASSERT_EQ(build(lidar_section(more)), "");
    client = client_of(lsr::kCode, 1);
  }
  void say(const std::string& hex) { lidar->send(from_hex(hex)); }
  /// As the lidar of the capture.
  std::string start() {
    EXPECT_EQ(to_hex(lidar->take(0.2)), "a5 25 a5 50");
    say("a5 5a 14 00 00 00 04 18 14 01 05 00 01 02 03 04 05 06 07 08 09 0a 0b 0c 0d 0e 0f");
    EXPECT_EQ(to_hex(lidar->take()), "a5 52");
    say("a5 5a 03 00 00 00 06 00 00 00");
    return to_hex(lidar->take());
  }
  lsr::Data heard(double seconds = 0.5) {
    return latest<lsr::Data>(*client, lsr::kCode, lsr::kDataScan, seconds);
  }
  bool is_retired() {
    client->read();
    return server::outline(client->ask(server::open_request(lsr::kCode, 1))).find("NACK") !=
           std::string::npos;
  }

  std::unique_ptr<FarEnd> lidar;
  std::unique_ptr<server::TestClient> client;
};

/// Distances of the capture, 1000 mm and twice the angle, which runs clockwise.
TEST_F(RplidarScript, express_scans_are_those_of_the_capture) {
  begin();
  EXPECT_EQ(start(), "a5 82 05 00 00 00 00 00 22");
  lidar->send(rplidar::encode_descriptor(rplidar::kCapsuleBytes, true, rplidar::kCapsules));
  for (int k = 0; k < 60; ++k) {
    rplidar::LidarCapsule capsule{.is_first = k == 0, .angle = std::fmod(16.0 * k, 360)};
    for (std::size_t sample = 0; sample < rplidar::kSamplesOfCapsule; ++sample)
      capsule.ranges[sample] =
          static_cast<int>(1000 + 2 * std::fmod(capsule.angle + 0.5 * static_cast<double>(sample), 360));
    lidar->send(rplidar::encode_capsule(capsule));
  }
  const lsr::Data data = heard();
  ASSERT_EQ(data.ranges.size(), 360u);
  EXPECT_NEAR(data.min_angle, -pi, 1e-6);
  for (int degrees = -179; degrees < 180; ++degrees)
    EXPECT_NEAR(data.ranges[static_cast<std::size_t>(degrees + 180)], 1 + 0.002 * ((360 - degrees) % 360),
                0.0021)
        << degrees;
}

TEST_F(RplidarScript, standard_scans_have_a_quality) {
  begin(" express 0");
  EXPECT_EQ(start(), "a5 20");
  lidar->send(rplidar::encode_descriptor(rplidar::kNodeBytes, true, rplidar::kNodes));
  RawBytes nodes;
  for (int k = 0; k < 800; ++k) {
    const RawBytes node = rplidar::encode_node({k % 360 == 0, 47, k % 360 * 1.0, 1000.0 + 2 * (k % 360)});
    nodes.insert(nodes.end(), node.begin(), node.end());
  }
  lidar->send(nodes);
  const lsr::Data data = heard();
  ASSERT_EQ(data.ranges.size(), 360u);
  EXPECT_NEAR(data.ranges[180 + 90], 1 + 0.002 * 270, 1e-5);
  EXPECT_NEAR(data.ranges[180 - 90], 1 + 0.002 * 90, 1e-5);
  EXPECT_EQ(data.intensity[100], 47);
}

TEST_F(RplidarScript, old_ones_without_express_scans_are_asked_for_standard_ones) {
  begin();
  start();
  EXPECT_EQ(to_hex(lidar->take(1.5)), "a5 82 05 00 00 00 00 00 22 a5 82 05 00 00 00 00 00 22 a5 20");
}

TEST_F(RplidarScript, a_broken_one_is_reset_and_given_up) {
  begin();
  lidar->take(0.2);
  const std::string info = "a5 5a 14 00 00 00 04 18 14 01 05 00 01 02 03 04 05 06 07 08 09 0a 0b 0c 0d 0e 0f";
  say(info);
  lidar->take();
  say("a5 5a 03 00 00 00 06 02 34 12");
  EXPECT_EQ(to_hex(lidar->take(2.2)), "a5 40 a5 50");
  say(info);
  lidar->take();
  say("a5 5a 03 00 00 00 06 02 34 12");
  network_.run_for(0.1);
  EXPECT_TRUE(is_retired());
}

TEST_F(RplidarScript, one_at_the_other_speed_is_found) {
  begin("", {.baud = 256000});
  lidar->take(3.3);  // noise
  EXPECT_NE(to_hex(lidar->take(1)).find("a5 50"), std::string::npos);
}

TEST_F(RplidarScript, a_line_on_which_nothing_answers_retires) {
  begin();
  network_.run_for(6);
  EXPECT_TRUE(is_retired());
}

class RplidarPair : public HardwareTest {
 protected:
  server::FakeDriver& seen = add_device(lsr::kCode);

  void begin(const std::string& of_emulator = "", const std::string& more = "") {
    ASSERT_EQ(build(R"(driver( name "rplidar_emulator" port "/dev/lidar" requires ["laser:0"])" +
                    of_emulator + " )\n" + lidar_section(more)),
              "");
    client = client_of(lsr::kCode, 1);
    look();
    network_.run_for(2);
  }
  /// Of 180 degrees, beam k at 1 m + k cm, the last one without an echo.
  void look() {
    lsr::Data data{
        static_cast<float>(-pi / 2), static_cast<float>(pi / 2), static_cast<float>(pi / 180), 10, {}, {}, 0};
    for (int k = 0; k < 181; ++k) data.ranges.push_back(1 + 0.01F * static_cast<float>(k));
    data.ranges.back() = 10;
    publish(lsr::kCode, lsr::kDataScan, data);
  }
  lsr::Data heard(double seconds = 0.6) {
    return latest<lsr::Data>(*client, lsr::kCode, lsr::kDataScan, seconds);
  }
  /// A beam is of a sample within half a degree, which is of a beam within half a degree.
  static void expect_seen(const lsr::Data& data) {
    ASSERT_EQ(data.ranges.size(), 360u);
    for (int degrees = -180; degrees < 180; ++degrees) {
      const float range = data.ranges[static_cast<std::size_t>(degrees + 180)];
      if (degrees < -91 || degrees > 91) EXPECT_EQ(range, 12) << degrees;
      if (degrees > -89 && degrees < 88 && range < 12)
        EXPECT_NEAR(range, 1.9 + 0.01 * degrees, 0.011) << degrees;
    }
    EXPECT_LT(std::count(data.ranges.begin(), data.ranges.end(), 12.0F), 200) << "few beams have no sample";
  }

  std::unique_ptr<server::TestClient> client;
};

TEST_F(RplidarPair, what_is_seen_comes_through_in_express_scans) {
  begin();
  expect_seen(heard());
}

TEST_F(RplidarPair, and_in_standard_scans_and_with_older_firmware) {
  begin(R"( modes 0 )", " express 0");
  const lsr::Data data = heard();
  expect_seen(data);
  EXPECT_EQ(data.intensity.size(), 360u);
}

TEST_F(RplidarPair, an_a2_has_its_motor_switched_with_its_power) {
  begin(R"( model "A2" )", " resolution 2");
  EXPECT_EQ(heard().ranges.size(), 180u);
  client->ask(request(lsr::kCode, lsr::kReqPower, lsr::PowerConfig{0}, 1));
  network_.run_for(1);
  client->read();
  EXPECT_TRUE(heard(6).ranges.empty());
  client->ask(request(lsr::kCode, lsr::kReqPower, lsr::PowerConfig{1}, 1));
  network_.run_for(1);
  EXPECT_EQ(heard().ranges.size(), 180u);
}

TEST_F(RplidarPair, a_part_of_the_turn_is_chosen) {
  begin();
  client->ask(request(lsr::kCode, lsr::kReqSetConfig, lsr::Config{-0.5F, 0.5F, 0.05F, 0, 0, 0, 0}, 1));
  network_.run_for(0.5);
  const lsr::Data data = heard();
  ASSERT_EQ(data.ranges.size(), 21u);
  EXPECT_NEAR(data.ranges[10], 1.9, 0.03) << "the nearest within 1.4 degrees";
}

TEST_F(RplidarPair, a_pulled_plug_is_waited_for_with_reconnect) {
  begin("", " reconnect 1");
  network_.serial().unplug("/dev/lidar");
  network_.run_for(2);
  network_.serial().plug("/dev/lidar");
  network_.run_for(6);
  expect_seen(heard());
}

TEST_F(RplidarPair, a_pulled_plug_retires_the_devices) {
  begin();
  network_.serial().unplug("/dev/lidar");
  network_.run_for(1);
  client->read();
  EXPECT_NE(server::outline(client->ask(server::open_request(lsr::kCode, 1))).find("NACK"),
            std::string::npos);
}

TEST_F(RplidarPair, a_noisy_line_loses_samples_and_nothing_else) {
  begin();
  network_.serial().faults = {.loss = 0.001, .change = 0.001};
  network_.run_for(20);
  network_.serial().faults = {};
  network_.run_for(2);
  expect_seen(heard());
}

TEST_F(RplidarPair, sections_with_faults_say_what_is_valid) {
  EXPECT_EQ(build(R"(driver( name "rplidar" provides ["laser:1"] resolution 50 ))"),
            "test.cfg:1: resolution is at most 30");
  EXPECT_EQ(build(R"(driver( name "rplidar_emulator" requires ["laser:0"] port "/dev/lidar" model "A9" ))"),
            "test.cfg:1: model is A1 or A2");
}

}  // namespace
}  // namespace playhouse::drivers
