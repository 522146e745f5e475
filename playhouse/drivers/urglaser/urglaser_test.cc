// The driver against a script that says what a scanner said to other hosts, and against the emulator.

#include "playhouse/drivers/urglaser/urglaser.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "playhouse/drivers/hardware/testing_hardware.h"
#include "playhouse/drivers/urglaser/scip_frames.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/ranger.h"

namespace playhouse::drivers {
namespace {

namespace lsr = wire::laser;
namespace rng = wire::ranger;
using std::numbers::pi;
using testing::FarEnd;
using testing::HardwareTest;

std::string urg_section(const std::string& more = "") {
  return R"(driver( name "urglaser" port "/dev/urg" provides ["laser:1" "ranger:1"] )" + more + " )";
}

RawBytes said(std::string_view text) {
  RawBytes bytes;
  put_text(bytes, text);
  return bytes;
}
std::string text_of(std::span<const std::byte> bytes) {
  std::string text;
  for (const std::byte byte : bytes) text += static_cast<char>(byte);
  return text;
}

class UrgScript : public HardwareTest {
 protected:
  void begin(const std::string& more = "", int baud = 115200) {
    urg = std::make_unique<FarEnd>(network_, "/dev/urg", net::SerialSettings{.baud = baud});
    ASSERT_EQ(build(urg_section(more)), "");
    client = client_of(lsr::kCode, 1);
  }
  void say(std::string_view text) { urg->send(said(text)); }
  void start() {
    EXPECT_EQ(text_of(urg->take()), "QT\n");
    say("QT\n00P\n\n");
    EXPECT_EQ(text_of(urg->take()), "PP\n");
    urg->send(scip::encode_reply("PP", "00", scip::parameter_lines(scip::scip_models().front()), true));
    EXPECT_EQ(text_of(urg->take()), "VV\n");
    say("VV\n00P\nVEND:Hokuyo Automatic Co.,Ltd.;[\n\n");
    EXPECT_EQ(text_of(urg->take()), "MD0044072501000\n");
    say("MD0044072501000\n00P\n\n");
  }
  /// As in the capture: 1000 mm and the number of the step; step 50 is none.
  static RawBytes scan() {
    std::string data;
    for (int step = 44; step <= 725; ++step) data += scip::encode_number(step == 50 ? 7 : 1000 + step, 3);
    std::vector<std::string> lines = {"002PR"};
    for (const std::string& line : scip::data_lines(data, true)) lines.push_back(line);
    return scip::encode_reply("MD0044072501000", "99", lines, true);
  }
  lsr::Data heard(double seconds = 0.5) {
    return latest<lsr::Data>(*client, lsr::kCode, lsr::kDataScan, seconds);
  }
  bool is_retired() {
    client->read();
    return server::outline(client->ask(server::open_request(lsr::kCode, 1))).find("NACK") !=
           std::string::npos;
  }

  std::unique_ptr<FarEnd> urg;
  std::unique_ptr<server::TestClient> client;
};

TEST_F(UrgScript, scans_are_those_of_the_capture) {
  begin();
  start();
  urg->send(scan());
  const lsr::Data data = heard();
  ASSERT_EQ(data.ranges.size(), 682u);
  EXPECT_NEAR(data.ranges[0], 1.044, 1e-6);
  EXPECT_NEAR(data.ranges[681], 1.725, 1e-6);
  EXPECT_EQ(data.ranges[6], 5.6F) << "below 20 mm it is none";
  EXPECT_NEAR(data.min_angle, -340 * 2 * pi / 1024, 1e-5);
  EXPECT_NEAR(data.max_angle, 341 * 2 * pi / 1024, 1e-5);
  EXPECT_NEAR(data.resolution, 2 * pi / 1024, 1e-7);
}

TEST_F(UrgScript, one_that_speaks_scip_1_is_told_to_speak_2) {
  begin();
  urg->take();
  say("QT\nE\n\n");
  EXPECT_EQ(text_of(urg->take()), "SCIP2.0\n");
  say("SCIP2.0\n0\n\n");
  start();
  urg->send(scan());
  EXPECT_EQ(heard().ranges.size(), 682u);
}

TEST_F(UrgScript, a_scanner_at_another_speed_is_found_and_set) {
  begin("", 19200);
  urg->take(1.5);  // noise
  EXPECT_EQ(text_of(urg->take(0.3)), "QT\n");
  say("QT\n00P\n\n");
  EXPECT_EQ(text_of(urg->take()), "SS115200\n");
}

TEST_F(UrgScript, damaged_scans_are_left_out_and_the_next_is_read) {
  begin();
  start();
  RawBytes flipped = scan();
  flipped[300] ^= std::byte{1};
  urg->send(flipped);
  EXPECT_TRUE(heard().ranges.empty());
  const RawBytes whole = scan();
  urg->send(std::span(whole).first(1000));
  urg->send(whole);  // one answer with that before it
  urg->send(whole);
  EXPECT_EQ(heard(1).ranges.size(), 682u);
}

TEST_F(UrgScript, a_silent_scanner_is_started_again_and_given_up) {
  begin();
  start();
  urg->send(scan());
  EXPECT_EQ(heard().ranges.size(), 682u);
  EXPECT_TRUE(text_of(urg->take(3.2)).starts_with("QT\n"));
  network_.run_for(8);
  EXPECT_TRUE(is_retired());
}

TEST_F(UrgScript, a_line_on_which_nothing_answers_retires) {
  begin();
  network_.run_for(7);
  EXPECT_TRUE(is_retired());
}

class UrgPair : public HardwareTest {
 protected:
  server::FakeDriver& seen = add_device(lsr::kCode);

  void begin(const std::string& of_emulator = " baud 115200", const std::string& more = "") {
    ASSERT_EQ(build(R"(driver( name "urglaser_emulator" port "/dev/urg" requires ["laser:0"])" + of_emulator +
                    " )\n" + urg_section(more)),
              "");
    client = client_of(lsr::kCode, 1);
    look();
    network_.run_for(3);
  }
  /// Of 180 degrees, beam k at 1 m + k cm, the last one without an echo.
  void look() {
    lsr::Data data{
        static_cast<float>(-pi / 2), static_cast<float>(pi / 2), static_cast<float>(pi / 180), 10, {}, {}, 0};
    for (int k = 0; k < 181; ++k) {
      data.ranges.push_back(1 + 0.01F * static_cast<float>(k));
      data.intensity.push_back(k == 90 ? 9 : 0);
    }
    data.ranges.back() = 10;
    publish(lsr::kCode, lsr::kDataScan, data);
  }
  lsr::Data heard(double seconds = 0.5) {
    return latest<lsr::Data>(*client, lsr::kCode, lsr::kDataScan, seconds);
  }
  /// Each beam is that of the laser next to it; where that does not look there is none.
  static void expect_seen(const lsr::Data& data) {
    ASSERT_GT(data.ranges.size(), 10u);
    for (std::size_t k = 0; k < data.ranges.size(); ++k) {
      const double degrees =
          static_cast<double>(data.min_angle + static_cast<float>(k) * data.resolution) * 180 / pi;
      const double beam = std::round(degrees) + 90;
      if (beam < 0 || beam > 179)
        EXPECT_EQ(data.ranges[k], data.max_range) << degrees;
      else if (std::fabs(degrees - std::round(degrees)) < 0.49)
        EXPECT_NEAR(data.ranges[k], 1 + 0.01 * beam, 0.0006) << degrees;
    }
  }
  void set(const lsr::Config& wanted) {
    client->ask(request(lsr::kCode, lsr::kReqSetConfig, wanted, 1));
    network_.run_for(1);
  }

  std::unique_ptr<server::TestClient> client;
};

TEST_F(UrgPair, what_is_seen_comes_through_in_millimetres) {
  begin();
  const lsr::Data data = heard();
  EXPECT_EQ(data.ranges.size(), 682u);
  expect_seen(data);
}

TEST_F(UrgPair, each_model_has_its_angles_and_its_rate) {
  begin(R"( baud 115200 model "UXM-30LX-EW")");
  const lsr::Data data = heard();
  EXPECT_EQ(data.ranges.size(), 761u);
  EXPECT_NEAR(data.max_angle, 95 * pi / 180, 1e-5);
  expect_seen(data);
}

TEST_F(UrgPair, old_ones_that_begin_in_scip_1_work) {
  begin(" baud 115200 scip1 1");
  expect_seen(heard());
}

TEST_F(UrgPair, one_at_another_speed_is_set) {
  begin(" baud 19200");
  network_.run_for(3);
  expect_seen(heard());
}

TEST_F(UrgPair, angles_resolution_and_rate_are_chosen) {
  begin();
  set({-0.5F, 0.5F, 0.0123F, 0, 0, 0, 5});
  client->read();
  network_.run_for(2);
  std::size_t scans = 0;
  lsr::Data data;
  for (const server::Received& each : client->read()) {
    if (each.header.type != wire::MessageType::kData) continue;
    ++scans;
    data = *wire::decode<lsr::Data>(each.body);
  }
  EXPECT_NEAR(static_cast<double>(scans), 10, 1) << "of 10 Hz each second one";
  EXPECT_NEAR(data.resolution, 2 * 2 * pi / 1024, 1e-6) << "of two steps";
  EXPECT_NEAR(data.min_angle, -0.5, 0.01);
  EXPECT_NEAR(data.max_angle, 0.5, 0.01);
  for (std::size_t k = 0; k < data.ranges.size(); ++k)
    EXPECT_NEAR(
        data.ranges[k],
        1.9 + 0.01 * static_cast<double>(data.min_angle + static_cast<float>(k) * data.resolution) * 180 / pi,
        0.011);
}

TEST_F(UrgPair, intensities_come_if_they_are_asked_for) {
  begin();
  EXPECT_TRUE(heard().intensity.empty());
  set({-2, 2, 0, 0, 0, 1, 0});
  const lsr::Data data = heard();
  ASSERT_EQ(data.intensity.size(), data.ranges.size());
  EXPECT_EQ(data.intensity[static_cast<std::size_t>(std::lround(-data.min_angle / data.resolution))], 9);
  EXPECT_EQ(data.intensity[0], 0);
}

TEST_F(UrgPair, without_power_there_are_no_scans) {
  begin();
  client->ask(request(lsr::kCode, lsr::kReqPower, lsr::PowerConfig{0}, 1));
  network_.run_for(0.5);
  client->read();
  EXPECT_TRUE(heard(5).ranges.empty());
  client->ask(request(lsr::kCode, lsr::kReqPower, lsr::PowerConfig{1}, 1));
  network_.run_for(0.5);
  expect_seen(heard());
}

TEST_F(UrgPair, both_interfaces_have_the_same_scans) {
  begin();
  const auto other = client_of(rng::kCode, 1);
  EXPECT_EQ(latest<rng::DataRange>(*other, rng::kCode, rng::kDataRange, 1).ranges.size(), 682u);
  const auto config =
      wire::decode<rng::Config>(other->ask(question(rng::kCode, rng::kReqGetConfig, 1)).back().body);
  EXPECT_NEAR(config->max_range, 5.6, 1e-9);
  EXPECT_NEAR(config->min_range, 0.02, 1e-9);
  EXPECT_NEAR(config->frequency, 10, 1e-9);
}

TEST_F(UrgPair, a_pulled_plug_is_waited_for_with_reconnect) {
  begin(" baud 115200", " reconnect 1");
  network_.serial().unplug("/dev/urg");
  network_.run_for(2);
  network_.serial().plug("/dev/urg");
  network_.run_for(6);
  expect_seen(heard());
}

TEST_F(UrgPair, a_pulled_plug_retires_the_devices) {
  begin();
  network_.serial().unplug("/dev/urg");
  network_.run_for(1);
  client->read();
  EXPECT_NE(server::outline(client->ask(server::open_request(lsr::kCode, 1))).find("NACK"),
            std::string::npos);
}

TEST_F(UrgPair, a_noisy_line_loses_scans_and_nothing_else) {
  begin();
  network_.serial().faults = {.loss = 0.0001, .change = 0.0001};
  network_.run_for(30);
  network_.serial().faults = {};
  network_.run_for(6);
  expect_seen(heard());
}

/// Other people's drivers use what ours does not.
class UrgAlone : public HardwareTest {
 protected:
  void begin(const std::string& more = "") {
    add_device(lsr::kCode);
    ASSERT_EQ(build(R"(driver( name "urglaser_emulator" port "/dev/urg" requires ["laser:0"] baud 115200 )" +
                    more + " )"),
              "");
    host_ = *network_.open_serial("/dev/urg", {.baud = 115200});
    host_->start(heard_);
    publish(
        lsr::kCode, lsr::kDataScan,
        lsr::Data{-3, 3, 0.01F, 8, std::vector<float>(601, 1.234F), std::vector<std::uint8_t>(601, 5), 0});
    network_.run_for(0.1);
  }
  std::string ask(const std::string& line, double seconds = 0.4) {
    host_->send(said(line + "\n"));
    network_.run_for(seconds);
    return text_of(std::exchange(heard_.bytes, {}));
  }

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

TEST_F(UrgAlone, answers_as_a_scanner_does) {
  begin();
  EXPECT_EQ(ask("QT"), "QT\n00P\n\n");
  EXPECT_EQ(ask("QT;abc"), "QT;abc\n00P\n\n");
  EXPECT_EQ(ask("QT;12345678901234567").substr(21, 2), "0G");
  EXPECT_EQ(ask("V"), "V\n0Ee\n\n");
  EXPECT_TRUE(ask("PP").ends_with("AFRT:384;6\nSCAN:600;e\n\n"));
  EXPECT_TRUE(ask("VV").starts_with("VV\n00P\nVEND:Hokuyo Automatic Co.,Ltd.;[\n"));
  EXPECT_NE(ask("II").find("LASR:OFF;"), std::string::npos);
  EXPECT_EQ(ask("%ST"), "%ST\n00P\n000@\n\n");
  EXPECT_EQ(ask("TM1"), "TM1\n04T\n\n");
  EXPECT_EQ(ask("TM0"), "TM0\n00P\n\n");
  EXPECT_EQ(ask("TM1").size(), 15u) << "echo, status, four characters and their check";
  EXPECT_EQ(ask("TM2"), "TM2\n00P\n\n");
  EXPECT_EQ(ask("SS115200"), "SS115200\n03S\n\n");
  EXPECT_EQ(ask("SSabc"), "SSabc\n01Q\n\n");
  EXPECT_EQ(ask("GD0044072501"), "GD0044072501\n10Q\n\n") << "the laser is off";
  EXPECT_EQ(ask("BM"), "BM\n00P\n\n");
  EXPECT_EQ(ask("BM"), "BM\n02R\n\n");
  EXPECT_EQ(ask("%ST"), "%ST\n00P\n003C\n\n");
  EXPECT_EQ(ask("GD0044076901").substr(13, 2), "04");
  EXPECT_EQ(ask("GD0044004301").substr(13, 2), "05");
  EXPECT_EQ(ask("GDxx44004301").substr(13, 2), "01");
  EXPECT_EQ(ask("GD0044").substr(7, 2), "0C");
}

TEST_F(UrgAlone, scans_have_the_width_and_the_count_that_is_asked_for) {
  begin();
  ask("BM");
  const auto data_of = [](const std::string& text) {
    return text.substr(text.find('\n', text.find('P') + 2) + 1);
  };
  EXPECT_TRUE(data_of(ask("GD0384038501")).starts_with("0CB0CB"));
  EXPECT_TRUE(data_of(ask("GS0384038501")).starts_with("CBCB"));
  EXPECT_TRUE(data_of(ask("GE0384038501")).starts_with("0CB01@0CB01@"));
  EXPECT_TRUE(data_of(ask("GD0000000101")).starts_with("000000")) << "outside of what it measures";
  ask("QT");
  const std::string two = ask("MD0384038501002");
  EXPECT_TRUE(two.starts_with("MD0384038501002\n00P\n\nMD0384038501001\n99b\n")) << two;
  EXPECT_NE(two.find("MD0384038501000\n99b\n"), std::string::npos);
  EXPECT_EQ(two.find("MD", 60), std::string::npos) << two;
  EXPECT_NE(ask("II").find("LASR:OFF;"), std::string::npos);
  ask("MD0384038501100", 1);
  ask("QT");
  EXPECT_EQ(ask("BM"), "BM\n00P\n\n") << "and nothing of the scans that were stopped";
}

TEST_F(UrgAlone, in_scip_1_it_answers_as_old_ones_do) {
  begin(" scip1 1");
  EXPECT_EQ(ask("QT"), "QT\nE\n\n");
  EXPECT_TRUE(ask("V").starts_with("V\n0\nVEND:Hokuyo Automatic Co.,Ltd.\nPROD:"));
  EXPECT_EQ(ask("S1152000000000"), "S1152000000000\n0\n\n");
  EXPECT_EQ(ask("G38438501"), "G38438501\n0\nCBCB\n\n");
  EXPECT_EQ(ask("SCIP2.0"), "SCIP2.0\n0\n\n");
  EXPECT_EQ(ask("SCIP2.0"), "SCIP2.0\n0Ee\n\n");
}

TEST_F(UrgAlone, sections_with_faults_say_what_is_valid) {
  const auto fault = [this](const std::string& section) { return build("driver( name " + section + " )"); };
  EXPECT_EQ(fault(R"("urglaser" provides ["laser:1"] min_angle 20 max_angle 10)"),
            "test.cfg:1: max_angle is more than min_angle");
  EXPECT_EQ(fault(R"("urglaser_emulator" requires ["laser:0"] port "/dev/urg" model "LMS")"),
            "test.cfg:1: model is URG-04LX, UTM-30LX, UST-10LX, UST-20LX or UXM-30LX-EW, not \"LMS\"");
}

}  // namespace
}  // namespace playhouse::drivers
