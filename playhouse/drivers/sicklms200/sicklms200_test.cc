// The driver against a script that says what a laser said to the original driver, and against the emulator.

#include "playhouse/drivers/sicklms200/sicklms200.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "playhouse/drivers/hardware/testing_hardware.h"
#include "playhouse/drivers/sicklms200/lms_telegrams.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/ranger.h"

namespace playhouse::drivers {
namespace {

namespace lsr = wire::laser;
namespace rng = wire::ranger;
using std::numbers::pi;
using testing::FarEnd;
using testing::from_hex;
using testing::HardwareTest;
using testing::to_hex;

std::string lms_section(const std::string& more = "") {
  return R"(driver( name "sicklms200" port "/dev/laser" provides ["laser:1" "ranger:1"] )" + more + " )";
}

class SickScript : public HardwareTest {
 protected:
  void begin(const std::string& more = " connect_rate [9600] transfer_rate 9600", int baud = 9600) {
    laser = std::make_unique<FarEnd>(network_, "/dev/laser", net::SerialSettings{.baud = baud});
    ASSERT_EQ(build(lms_section(more)), "");
    client = client_of(lsr::kCode, 1);
  }
  void say(const std::string& hex) { laser->send(from_hex(hex)); }
  /// As the laser of the capture: scans of 180 degrees every 0.5 degrees, in millimetres.
  void start() {
    EXPECT_EQ(to_hex(laser->take()), "02 00 02 00 20 25 35 08");
    say("06 02 80 03 00 a0 00 10 16 0a");
    EXPECT_EQ(to_hex(laser->take(1.2)), "02 00 01 00 3a 1e 12");
    say("06 02 80 16 00 ba 4c 4d 53 32 30 30 3b 33 30 31 30 36 3b 56 30 32 2e 31 30 20 10 99 ab");
    EXPECT_EQ(to_hex(laser->take()), "02 00 0a 00 20 00 53 49 43 4b 5f 4c 4d 53 be c5");
    say("06 02 80 03 00 a0 00 10 16 0a");
    EXPECT_EQ(to_hex(laser->take()), "02 00 01 00 31 15 12");
    laser->send(sick::from_laser(sick::encode_state({.version = "V02.10 ", .variant = {180, 100}})));
    EXPECT_EQ(to_hex(laser->take(0.3)), "02 00 05 00 3b b4 00 32 00 3b 1f");
    say("06 02 80 07 00 bb 01 b4 00 32 00 10 03 9d");
    EXPECT_EQ(to_hex(laser->take()), "02 00 01 00 74 50 12");
    say("02 80 23 00 f4 00 00 46 00 00 00 00 00 00 00 02 02 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 "
        "00 00 00 00 00 00 10 d5 c9");
    EXPECT_EQ(to_hex(laser->take(0.2)), "02 00 08 00 77 00 00 46 00 00 01 01 a2 4e");
    say("06 02 80 24 00 f7 01 00 00 46 00 00 01 01 00 00 00 02 02 00 00 00 00 00 00 00 00 00 00 00 00 00 00 "
        "00 00 00 00 00 00 00 10 94 bd");
    EXPECT_EQ(to_hex(laser->take(0.2)), "02 00 02 00 20 24 34 08");
    say("02 80 03 00 a0 00 10 16 0a");
  }
  /// The scan of the capture: 1000, 1010 ... mm, an intensity of 1 at 50, a code of no echo at 60.
  static RawBytes scan() {
    sick::LmsScan scan{.unit = sick::kMillimetre, .values = {}};
    for (int k = 0; k < 361; ++k) scan.values.push_back(1000 + 10 * k);
    scan.values[50] |= 1 << 13;
    scan.values[60] = 0x1FFF;
    return sick::from_laser(sick::encode_scan(scan));
  }
  lsr::Data heard(double seconds = 1) {
    return latest<lsr::Data>(*client, lsr::kCode, lsr::kDataScan, seconds);
  }
  bool is_retired() {
    client->read();
    const std::string outline = server::outline(client->ask(server::open_request(lsr::kCode, 1)));
    return outline.find("NACK") != std::string::npos;
  }

  std::unique_ptr<FarEnd> laser;
  std::unique_ptr<server::TestClient> client;
};

TEST_F(SickScript, starts_as_the_original_does_and_reads_its_scan) {
  begin();
  EXPECT_EQ(access, 1);
  start();
  laser->send(scan());
  const lsr::Data data = heard();
  ASSERT_EQ(data.ranges.size(), 361u);
  EXPECT_NEAR(data.min_angle, -pi / 2, 1e-6);
  EXPECT_NEAR(data.max_angle, pi / 2, 1e-6);
  EXPECT_NEAR(data.resolution, 0.0087266, 1e-6);
  EXPECT_EQ(data.max_range, 8.0F);
  EXPECT_NEAR(data.ranges[0], 1.0, 1e-6);
  EXPECT_NEAR(data.ranges[50], 1.5, 1e-6);
  EXPECT_EQ(data.ranges[60], 8.0F) << "the original says 8.191";
  EXPECT_EQ(data.intensity[50], 1);
}

TEST_F(SickScript, the_configuration_is_told_and_set_as_with_the_original) {
  begin();
  start();
  const auto ask = [&](const Bytes& message) {
    const auto answers = client->ask(message);
    return answers.empty() ? lsr::Config{} : *wire::decode<lsr::Config>(answers.back().body);
  };
  const lsr::Config now = ask(question(lsr::kCode, lsr::kReqGetConfig, 1));
  EXPECT_NEAR(now.resolution, 0.0087266, 1e-6);
  EXPECT_NEAR(now.range_res, 0.001, 1e-6);
  const lsr::Config wanted{-0.785398F, 0.785398F, 50, 0, 10, 1, 0};
  const lsr::Config set = ask(request(lsr::kCode, lsr::kReqSetConfig, wanted, 1));
  EXPECT_EQ(set.resolution, 50) << "in the units of the question";
  EXPECT_EQ(set.range_res, 10);
  EXPECT_EQ(set.max_range, 80);
  EXPECT_NEAR(set.min_angle, -pi / 4, 1e-6);

  EXPECT_EQ(to_hex(laser->take()), "02 00 0a 00 20 00 53 49 43 4b 5f 4c 4d 53 be c5");
  laser->send(scan());  // one that was on its way
  say("02 80 03 00 a0 00 10 16 0a");
  EXPECT_EQ(to_hex(laser->take(1)), "02 00 01 00 31 15 12");
  laser->send(sick::from_laser(sick::encode_state({.version = "V02.10 ", .variant = {180, 50}})));
  EXPECT_EQ(to_hex(laser->take(0.3)), "02 00 01 00 74 50 12");
  say("02 80 23 00 f4 00 00 46 00 00 01 01 00 00 00 02 02 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 "
      "00 00 00 00 00 10 25 99");
  EXPECT_EQ(to_hex(laser->take(0.2)), "02 00 08 00 77 00 00 46 00 00 01 00 a3 4e");
  say("02 80 24 00 f7 01 00 00 46 00 00 01 00 00 00 00 02 02 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 "
      "00 00 00 00 00 10 c4 8d");
  EXPECT_EQ(to_hex(laser->take(0.2)), "02 00 06 00 20 27 5b 00 0f 01 b2 58");
  say("02 80 03 00 a0 00 10 16 0a");
  sick::LmsScan part{.first = 91, .is_part = true, .values = std::vector<int>(181, 1900)};
  laser->send(sick::from_laser(sick::encode_scan(part)));
  const lsr::Data data = heard();
  ASSERT_EQ(data.ranges.size(), 181u);
  EXPECT_NEAR(data.ranges[0], 19.0, 1e-5);
  EXPECT_NEAR(data.max_angle, pi / 4, 1e-6);
}

TEST_F(SickScript, what_the_laser_cannot_do_is_refused) {
  begin();
  const auto is_refused = [&](const lsr::Config& wanted) {
    return server::outline(client->ask(request(lsr::kCode, lsr::kReqSetConfig, wanted, 1))).find("NACK") !=
           std::string::npos;
  };
  EXPECT_TRUE(is_refused({-1, 1, 0.005F, 0, 0, 1, 0})) << "0.29 degrees";
  EXPECT_TRUE(is_refused({-1, 1, 50, 0, 5, 1, 0})) << "5 mm";
  EXPECT_TRUE(is_refused({1, -1, 50, 0, 1, 1, 0}));
  EXPECT_TRUE(is_refused({NAN, 1, 50, 0, 1, 1, 0}));
  EXPECT_FALSE(is_refused({-1, 1, 25, 0, 10, 1, 0}));
}

TEST_F(SickScript, a_laser_at_another_speed_is_found) {
  begin(" connect_rate [9600 38400] transfer_rate 38400", 38400);
  laser->take(3.5);  // noise
  const RawBytes asked = laser->take(1);
  EXPECT_EQ(to_hex(asked).find("02 00 02 00 20 25 35 08"), 0u) << to_hex(asked);
}

TEST_F(SickScript, damaged_scans_are_left_out_and_the_next_is_read) {
  begin();
  start();
  RawBytes flipped = scan();
  flipped[100] ^= std::byte{4};
  laser->send(flipped);
  EXPECT_TRUE(heard().ranges.empty());
  say("00 55 02");
  const RawBytes whole = scan();
  laser->send(std::span(whole).first(200));
  laser->send(whole);
  EXPECT_EQ(heard(1.5).ranges.size(), 361u);
}

TEST_F(SickScript, a_laser_that_falls_silent_is_started_again_and_given_up) {
  begin();
  start();
  laser->send(scan());
  heard();
  EXPECT_TRUE(to_hex(laser->take(3.2)).starts_with("02 00 02 00 20 25 35 08"));
  network_.run_for(5);
  EXPECT_TRUE(is_retired());
}

TEST_F(SickScript, a_line_on_which_nothing_answers_retires) {
  begin();
  network_.run_for(4);
  EXPECT_TRUE(is_retired());
}

TEST_F(SickScript, a_laser_that_refuses_the_password_is_given_up) {
  begin();
  laser->take();
  say("06 02 80 03 00 a0 00 10 16 0a");
  laser->take(1.2);
  RawBytes type{std::byte{sick::kType}};
  put_text(type, "LMS291");
  laser->send(sick::from_laser(type));
  laser->take();
  RawBytes refused{std::byte{sick::kModeSet}, std::byte{1}};
  laser->send(sick::from_laser(refused));
  network_.run_for(0.2);
  EXPECT_TRUE(is_retired());
}

TEST_F(SickScript, a_pls_is_asked_for_nothing_but_its_scans) {
  laser = std::make_unique<FarEnd>(network_, "/dev/laser",
                                   net::SerialSettings{.parity = net::SerialParity::kEven});
  ASSERT_EQ(build(R"(driver( name "sickpls" port "/dev/laser" provides ["laser:1"] )"
                  R"(connect_rate [9600] transfer_rate 9600 ))"),
            "");
  client = client_of(lsr::kCode, 1);
  EXPECT_EQ(to_hex(laser->take()), "02 00 02 00 20 25 35 08");
  say("06 02 80 03 00 a0 00 10 16 0a");
  EXPECT_EQ(to_hex(laser->take(1.2)), "02 00 02 00 20 24 34 08");
  say("06 02 80 03 00 a0 00 10 16 0a");
  laser->send(sick::from_laser(sick::encode_scan({.values = std::vector<int>(361, 512)})));
  const lsr::Data data = heard();
  ASSERT_EQ(data.ranges.size(), 361u);
  EXPECT_NEAR(data.ranges[7], 5.12, 1e-5) << "in centimetres";
}

TEST_F(SickScript, all_speeds_are_tried_again_after_the_delay_as_often_as_is_said) {
  begin(" connect_rate [9600] transfer_rate 9600 delay 5 retry 1");
  EXPECT_EQ(to_hex(laser->take(4.9)), "");
  laser->take(3);
  EXPECT_EQ(to_hex(laser->take(2.5)).substr(0, 23), "02 00 02 00 20 25 35 08");
  network_.run_for(2);
  EXPECT_TRUE(is_retired());
}

class SickPair : public HardwareTest {
 protected:
  server::FakeDriver& seen = add_device(lsr::kCode);

  void begin(const std::string& more = "", const std::string& of_emulator = "") {
    ASSERT_EQ(build(R"(driver( name "sicklms200_emulator" port "/dev/laser" requires ["laser:0"])" +
                    of_emulator + " )\n" + lms_section(more)),
              "");
    client = client_of(lsr::kCode, 1);
    look();
    network_.run_for(6);
  }
  /// Of 180 degrees, beam k at 1 m + k cm, the last one without an echo.
  void look(float shift = 0) {
    lsr::Data data{
        static_cast<float>(-pi / 2), static_cast<float>(pi / 2), static_cast<float>(pi / 180), 10, {}, {}, 0};
    for (int k = 0; k < 181; ++k) {
      data.ranges.push_back(1 + 0.01F * static_cast<float>(k) + shift);
      data.intensity.push_back(k == 90 ? 1 : 0);
    }
    data.ranges.back() = 10;
    publish(lsr::kCode, lsr::kDataScan, data);
  }
  lsr::Data heard(double seconds = 1) {
    return latest<lsr::Data>(*client, lsr::kCode, lsr::kDataScan, seconds);
  }
  void expect_usual(const lsr::Data& data) {
    ASSERT_EQ(data.ranges.size(), 361u);
    for (std::size_t k = 0; k < 360; k += 2)
      ASSERT_NEAR(data.ranges[k], 1 + 0.005 * static_cast<double>(k), 0.0011) << k;
    EXPECT_EQ(data.ranges[360], 8.0F);
    EXPECT_EQ(data.intensity[180], 1);
    EXPECT_EQ(data.intensity[100], 0);
  }

  std::unique_ptr<server::TestClient> client;
};

TEST_F(SickPair, what_is_seen_comes_through_in_millimetres) {
  begin();
  expect_usual(heard());
}

TEST_F(SickPair, both_interfaces_have_the_same_scans) {
  begin();
  const auto other = client_of(rng::kCode, 1);
  const auto ranges = latest<rng::DataRange>(*other, rng::kCode, rng::kDataRange, 1).ranges;
  ASSERT_EQ(ranges.size(), 361u);
  EXPECT_NEAR(ranges[100], 1.5, 0.001);
  const auto answer = other->ask(question(rng::kCode, rng::kReqGetConfig, 1));
  const auto config = wire::decode<rng::Config>(answer.back().body);
  EXPECT_NEAR(config->angular_res, pi / 360, 1e-9);
  EXPECT_NEAR(config->frequency, 4.69, 0.01);
}

TEST_F(SickPair, each_resolution_and_unit_is_one_that_the_emulator_has) {
  begin();
  const auto set = [&](const lsr::Config& wanted) {
    client->ask(request(lsr::kCode, lsr::kReqSetConfig, wanted, 1));
    network_.run_for(1.5);
    return heard();
  };
  const lsr::Data fine = set({-2, 2, 25, 0, 10, 1, 0});
  ASSERT_EQ(fine.ranges.size(), 401u);
  EXPECT_NEAR(fine.min_angle, -50 * pi / 180, 1e-6);
  EXPECT_NEAR(fine.ranges[0], 1.40, 0.0051) << "centimetres";
  const lsr::Data coarse = set({-0.1F, 0.1F, 100, 0, 1, 0, 0});
  ASSERT_EQ(coarse.ranges.size(), 13u) << "from -6 to 6 degrees";
  EXPECT_NEAR(coarse.ranges[6], 1.9, 0.0011);
  EXPECT_TRUE(coarse.intensity.empty());
  const lsr::Data far = set({-2, 2, 50, 0, 100, 1, 0});
  ASSERT_EQ(far.ranges.size(), 361u);
  EXPECT_NEAR(far.ranges[100], 1.5, 0.051) << "decimetres";
}

TEST_F(SickPair, without_power_there_are_no_scans) {
  begin();
  client->ask(request(lsr::kCode, lsr::kReqPower, lsr::PowerConfig{0}, 1));
  network_.run_for(1);
  client->read();
  EXPECT_TRUE(heard(5).ranges.empty());
  client->ask(request(lsr::kCode, lsr::kReqPower, lsr::PowerConfig{1}, 1));
  network_.run_for(1);
  expect_usual(heard());
}

TEST_F(SickPair, at_half_a_million_baud_scans_come_as_often_as_the_mirror_turns) {
  begin(" transfer_rate 500000");
  client->read();
  network_.run_for(2);
  std::size_t scans = 0;
  for (const server::Received& each : client->read())
    if (each.header.type == wire::MessageType::kData) ++scans;
  EXPECT_NEAR(static_cast<double>(scans), 75, 2);
}

TEST_F(SickPair, the_laser_is_found_again_at_the_speed_it_was_left_at) {
  begin();
  client->peer.reset();
  network_.run_for(1);
  client = client_of(lsr::kCode, 1);
  network_.run_for(2);
  expect_usual(heard());
}

TEST_F(SickPair, a_pulled_plug_is_waited_for_with_reconnect_and_retires_without) {
  begin(" reconnect 1");
  network_.serial().unplug("/dev/laser");
  network_.run_for(2);
  network_.serial().plug("/dev/laser");
  network_.run_for(6);
  look(0.1F);
  EXPECT_NEAR(heard().ranges[100], 1.6, 0.002);
}

TEST_F(SickPair, a_pulled_plug_retires_the_devices) {
  begin();
  network_.serial().unplug("/dev/laser");
  network_.run_for(1);
  client->read();
  EXPECT_NE(server::outline(client->ask(server::open_request(lsr::kCode, 1))).find("NACK"),
            std::string::npos);
}

TEST_F(SickPair, a_noisy_line_loses_scans_and_nothing_else) {
  begin();
  network_.serial().faults = {.loss = 0.0002, .change = 0.0002};
  network_.run_for(30);
  network_.serial().faults = {};
  network_.run_for(6);
  expect_usual(heard());
}

/// Other people's drivers use what ours does not.
class SickLaserAlone : public HardwareTest {
 protected:
  SickLaserAlone() {
    add_device(lsr::kCode);
    EXPECT_EQ(build(R"(driver( name "sicklms200_emulator" port "/dev/laser" requires ["laser:0"] ))"), "");
    host_ = *network_.open_serial("/dev/laser", {});
    host_->start(heard_);
    lsr::Data data{static_cast<float>(-pi / 2),
                   static_cast<float>(pi / 2),
                   static_cast<float>(pi / 180),
                   80,
                   std::vector<float>(181, 20.0F),
                   std::vector<std::uint8_t>(181, 5),
                   0};
    publish(lsr::kCode, lsr::kDataScan, data);
  }
  std::string ask(const RawBytes& telegram, double seconds = 0.2) {
    host_->send(telegram);
    network_.run_for(seconds);
    return to_hex(std::exchange(heard_.bytes, {}));
  }
  static RawBytes telegram(const std::string& hex) { return sick::to_laser(from_hex(hex)); }

 private:
  struct Heard final : net::SerialEvents {
    RawBytes bytes;
    void received(std::span<const std::byte> more) override {
      bytes.insert(bytes.end(), more.begin(), more.end());
    }
    void ended(const std::string&) override {}
  };
  Heard heard_;
  std::unique_ptr<net::SerialLine> host_;
};

TEST_F(SickLaserAlone, answers_as_a_laser_does) {
  EXPECT_EQ(ask(telegram("20 25")), "06 02 80 03 00 a0 00 10 16 0a");
  EXPECT_EQ(ask(telegram("3a")),
            "06 02 80 16 00 ba 4c 4d 53 32 30 30 3b 33 30 31 30 36 3b 56 30 32 2e 31 30 20 10 99 ab");
  EXPECT_EQ(ask(telegram("3b b4 00 32 00")), "06 02 80 07 00 bb 01 b4 00 32 00 10 03 9d");
  EXPECT_EQ(ask(telegram("3b b4 00 19 00")).substr(15, 17), "bb 00 b4 00 32 00") << "not of 180 degrees";
  EXPECT_EQ(ask(telegram("74")),
            "06 02 80 23 00 f4 00 00 46 00 00 00 00 00 00 00 02 02 00 00 00 00 00 00 00 00 00 00 00 00 00 "
            "00 00 00 00 00 00 00 00 10 d5 c9");
  EXPECT_EQ(ask(telegram("77 00 00 46 00 00 01 01")).substr(15, 5), "f7 00") << "without the password";
  EXPECT_EQ(ask(telegram("20 00 53 49 43 4b 5f 4c 4d 54")).substr(15, 5), "a0 01");
  EXPECT_EQ(ask(telegram("20 00 53 49 43 4b 5f 4c 4d 53")).substr(15, 5), "a0 00");
  EXPECT_EQ(ask(telegram("77 00 00 46 00 00 01 01")),
            "06 02 80 24 00 f7 01 00 00 46 00 00 01 01 00 00 00 02 02 00 00 00 00 00 00 00 00 00 00 00 00 00 "
            "00 00 00 00 00 00 00 00 10 94 bd");
  EXPECT_EQ(ask(telegram("20 66")).substr(15, 5), "a0 02");
  EXPECT_EQ(ask(telegram("55")).substr(15, 2), "92");
  RawBytes damaged = telegram("3a");
  damaged.back() ^= std::byte{1};
  EXPECT_EQ(ask(damaged), "15");
}

TEST_F(SickLaserAlone, measuring_modes_have_their_bits) {
  const auto value_of = [&](const std::string& mode, const std::string& unit) {
    ask(telegram("20 00 53 49 43 4b 5f 4c 4d 53"));
    ask(telegram("77 00 00 46 00 00 " + mode + " " + unit));
    return ask(telegram("30 01"), 0.6).substr(24, 5);
  };
  EXPECT_EQ(value_of("00", "00"), "d0 07") << "2000 cm";
  EXPECT_EQ(value_of("01", "00"), "d0 a7") << "and intensity 5";
  EXPECT_EQ(value_of("03", "00"), "d0 c7") << "3, of 2 bits";
  EXPECT_EQ(value_of("05", "00"), "d0 87") << "1, of 1 bit";
  EXPECT_EQ(value_of("01", "01"), "f7 1f") << "20 m are too far";
  EXPECT_EQ(value_of("05", "01"), "20 ce") << "but not for 15 bits";
}

TEST_F(SickLaserAlone, sends_scans_until_it_is_told_to_stop_and_takes_another_speed) {
  EXPECT_EQ(ask(telegram("20 24")), "06 02 80 03 00 a0 00 10 16 0a");
  EXPECT_EQ(ask({}, 1.5).substr(0, 20), "02 80 6e 01 b0 b5 00");
  ask(telegram("20 25"), 1);
  EXPECT_EQ(ask({}, 1), "");
  EXPECT_EQ(ask(telegram("20 40")), "06 02 80 03 00 a0 00 10 16 0a") << "at the speed before";
  EXPECT_EQ(ask(telegram("3a")).find("ba 4c 4d 53"), std::string::npos);
}

TEST_F(SickPair, sections_with_faults_say_what_is_valid) {
  const auto fault = [this](const std::string& section) { return build("driver( name " + section + " )"); };
  const std::string driver = R"("sicklms200" provides ["laser:1"] )";
  EXPECT_EQ(fault(driver + "resolution 30"), "test.cfg:1: resolution is 25, 50 or 100");
  EXPECT_EQ(fault(driver + "range_res 2"), "test.cfg:1: range_res is 1, 10 or 100");
  EXPECT_EQ(fault(driver + "transfer_rate 12345"),
            "test.cfg:1: transfer_rate is 9600, 19200, 38400 or 500000");
  EXPECT_EQ(fault(driver + "connect_rate [9600 1]"),
            "test.cfg:1: connect_rate is a list of 9600, 19200, 38400 and 500000");
  EXPECT_EQ(fault(R"("sicklms200_emulator" requires ["laser:0"])"),
            "test.cfg:1: port or tcp_port is needed, and one of them alone");
}

}  // namespace
}  // namespace playhouse::drivers
