// The driver against a script that says what a robot said to the original driver, and against the emulator.

#include "playhouse/drivers/khepera/khepera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/drivers/hardware/testing_hardware.h"
#include "playhouse/wire/generated/ir.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {
namespace {

namespace p2d = wire::position2d;
using testing::FarEnd;
using testing::HardwareTest;

constexpr const char* kKheperaSection =
    R"(driver( name "khepera" port "/dev/robot" provides ["position2d:1" "ir:1"] ))";

std::string with(std::string section, const std::string& more) {
  return section.insert(section.size() - 1, more);
}
std::string text_of(const RawBytes& bytes) {
  std::string text;
  for (const std::byte byte : bytes) text.push_back(static_cast<char>(byte));
  return text;
}
Bytes drive_command(double speed, double turn_rate) {
  return server::message(wire::MessageType::kCmd, p2d::kCode, 1, p2d::kCmdVel,
                         wire::encode(p2d::CmdVel{{speed, 0, turn_rate}, 1}));
}

class KheperaScript : public HardwareTest {
 protected:
  void begin(const std::string& more = "") {
    ASSERT_EQ(build(with(kKheperaSection, more)), "");
    client = client_of(p2d::kCode, 1);
    EXPECT_EQ(asked(), "\r\n");
    EXPECT_EQ(asked(0.1), "E\n");
    say("e,0,0");
    EXPECT_EQ(asked(), "D,0,0\n");
    say("d");
  }
  std::string asked(double seconds = 0.03) { return text_of(robot.take(seconds)); }
  void say(const std::string& answer) {
    const std::string text = answer + "\r\n";
    robot.send(std::as_bytes(std::span(text)));
  }
  /// Answers all until the robot is asked this; then with `answer`.
  void say_to(char letter, const std::string& answer) {
    for (int round = 0; round < 10; ++round) {
      const std::string now = asked();
      ASSERT_FALSE(now.empty());
      if (now[0] == letter) return say(answer);
      say(now[0] == 'H'   ? counters
          : now[0] == 'E' ? "e,0,0"
                          : std::string(1, static_cast<char>(now[0] + 32)));
    }
  }
  /// "" if nothing is commanded while it is asked twice around.
  std::string wheels_of(double speed, double turn_rate) {
    client->ask(drive_command(speed, turn_rate));
    for (int round = 0; round < 6; ++round) {
      const std::string now = asked();
      say(now[0] == 'H'   ? counters
          : now[0] == 'E' ? "e,0,0"
                          : std::string(1, static_cast<char>(now[0] + 32)));
      if (now[0] == 'D') return now;
    }
    return "";
  }

  FarEnd robot{network_, "/dev/robot", {.baud = 38400}};
  std::unique_ptr<server::TestClient> client;
  std::string counters = "h,0,0";
};

TEST_F(KheperaScript, starts_as_the_original_does_and_asks_in_turn) {
  begin();
  EXPECT_EQ(access, 1);
  EXPECT_EQ(asked(), "H\n");
  say("h,0,0");
  EXPECT_EQ(asked(), "E\n");
  say("e,0,0");
  EXPECT_EQ(asked(), "H\n") << "nobody wants the sensors";
  const auto other = client_of(wire::ir::kCode, 1);
  say("h,0,0");
  EXPECT_EQ(asked(), "E\n");
  say("e,0,0");
  EXPECT_EQ(asked(), "N\n");
}

TEST_F(KheperaScript, speeds_are_in_units_of_8_mm_a_second) {
  begin();
  EXPECT_EQ(wheels_of(0.08, 0), "D,10,10\n");
  EXPECT_EQ(wheels_of(0, 1), "D,-3,3\n") << "26 mm/s of each wheel; the original sends 475";
  EXPECT_EQ(wheels_of(0.06, 1), "D,4,11\n");
  EXPECT_EQ(wheels_of(-0.04, 0), "D,-5,-5\n");
  EXPECT_EQ(wheels_of(5, 0), "D,127,127\n");
  EXPECT_EQ(wheels_of(1e300, 0), "D,127,127\n");
  EXPECT_EQ(wheels_of(0, -1e300), "D,127,-127\n");
  EXPECT_EQ(wheels_of(NAN, 0), "");
}

TEST_F(KheperaScript, counters_make_the_pose_and_speeds_the_speed) {
  begin();
  say_to('H', "h,1000,2147483647");
  say_to('E', "e,5,5");
  say_to('H', "h,2000,-2147482649");
  auto state = latest<p2d::Data>(*client, p2d::kCode, p2d::kDataState, 0.02);
  EXPECT_NEAR(state.pos.px, 0.08, 1e-9) << "1000 pulses of 0.08 mm; the right one wraps";
  EXPECT_NEAR(state.vel.px, 0.04, 1e-9);
  say_to('H', "h,1675,-2147482324");
  state = latest<p2d::Data>(*client, p2d::kCode, p2d::kDataState, 0.02);
  EXPECT_NEAR(state.pos.pa, 1, 1e-9) << "650 pulses more to the right are 52 mm";
  say_to('H', "h,0,0");
  EXPECT_NEAR(latest<p2d::Data>(*client, p2d::kCode, p2d::kDataState, 0.02).pos.pa, 0, 1e-9)
      << "no data of a jump";
}

TEST_F(KheperaScript, sensors_are_ranges_to_white_paper_or_as_calibrated) {
  begin();
  const auto other = client_of(wire::ir::kCode, 1);
  say_to('N', "n,60,450,80,90,100,110,120,1023");
  const auto data = latest<wire::ir::Data>(*other, wire::ir::kCode, wire::ir::kDataRanges, 0.02);
  ASSERT_EQ(data.ranges.size(), 8u);
  EXPECT_NEAR(data.ranges[0], 0.1, 1e-6) << "and farther";
  EXPECT_NEAR(data.ranges[1], 0.02, 1e-6);
  EXPECT_NEAR(data.ranges[7], 0.008, 1e-6);
  EXPECT_EQ(data.voltages[3], 90);
}

TEST_F(KheperaScript, the_ranges_of_the_original_are_those_of_its_calibration_and_its_scale) {
  begin(" ir_calib_a 64.158 scale_factor 10");
  const auto other = client_of(wire::ir::kCode, 1);
  say_to('N', "n,60,70,80,90,100,110,120,1023");
  const auto data = latest<wire::ir::Data>(*other, wire::ir::kCode, wire::ir::kDataRanges, 0.02);
  ASSERT_EQ(data.ranges.size(), 8u);
  EXPECT_NEAR(data.ranges[0], 0.38647, 1e-4);
  EXPECT_NEAR(data.ranges[2], 0.372948, 1e-4);
}

TEST_F(KheperaScript, an_answer_that_is_late_or_damaged_costs_one_reading) {
  begin();
  EXPECT_EQ(asked(), "H\n");
  EXPECT_EQ(asked(0.12), "E\n") << "a tenth of a second was enough";
  say("h,1,1");
  EXPECT_EQ(asked(0.04), "") << "not what was asked";
  say("e,0,0");
  EXPECT_EQ(asked(), "H\n");
  say("h,1");
  EXPECT_EQ(asked(), "E\n");
}

TEST_F(KheperaScript, a_silent_robot_retires_with_its_devices) {
  ASSERT_EQ(build(kKheperaSection), "");
  client = client_of(p2d::kCode, 1);
  client->read();
  network_.run_for(3);
  EXPECT_EQ(server::outline(client->ask(server::open_request(p2d::kCode, 1))), "ACK 3, NACK 3");
}

/// The original leaves the robot driving.
TEST_F(KheperaScript, ends_with_the_wheels_still) {
  begin();
  wheels_of(0.08, 0);
  asked();
  client->peer.reset();
  EXPECT_TRUE(asked().ends_with("D,0,0\n"));
}

class KheperaPair : public HardwareTest {
 protected:
  server::FakeDriver& wheels = add_device(p2d::kCode);
  server::FakeDriver& eyes = add_device(wire::ir::kCode);

  void begin(const std::string& more = "", const std::string& of_emulator = "") {
    const std::string emulator =
        R"(driver( name "khepera_emulator" port "/dev/robot" requires ["position2d:0" "ir:0"] ))";
    ASSERT_EQ(build(with(emulator, of_emulator) + "\n" + with(kKheperaSection, more)), "");
    client = client_of(p2d::kCode, 1);
    network_.run_for(0.5);
  }
  p2d::CmdVel wanted() const { return *wire::decode<p2d::CmdVel>(wheels.commands.back().second); }
  p2d::Data stand(const wire::Pose2d& pose, const wire::Pose2d& speed = {}) {
    publish(p2d::kCode, p2d::kDataState, p2d::Data{pose, speed, 0});
    return latest<p2d::Data>(*client, p2d::kCode, p2d::kDataState, 0.2);
  }
  std::unique_ptr<server::TestClient> client;
};

TEST_F(KheperaPair, what_is_commanded_arrives_and_what_is_measured_comes_back) {
  begin();
  client->ask(drive_command(0.08, 0.6));
  network_.run_for(0.2);
  EXPECT_NEAR(wanted().vel.px, 0.08, 0.004) << "half a unit of 8 mm/s";
  EXPECT_NEAR(wanted().vel.pa, 0.6, 0.16);
  stand({1, 1, 0.5});
  double x = 1, y = 1, a = 0.5;
  for (int step = 0; step < 20; ++step) {
    a += 0.1;
    x += 0.02 * std::cos(a - 0.05);
    y += 0.02 * std::sin(a - 0.05);
    stand({x, y, a});
  }
  const auto now = stand({x, y, a}, {0.04, 0, 0.3});
  const auto later = stand({x, y, a}, {0.04, 0, 0.3});
  EXPECT_NEAR(now.pos.pa, 2, 0.004) << "a pulse is 1.5 mrad";
  EXPECT_NEAR(now.pos.px, std::cos(0.5) * (x - 1) + std::sin(0.5) * (y - 1), 0.001);
  EXPECT_NEAR(now.pos.py, -std::sin(0.5) * (x - 1) + std::cos(0.5) * (y - 1), 0.001);
  EXPECT_NEAR(later.vel.px, 0.04, 0.004);
  EXPECT_NEAR(later.vel.pa, 0.3, 0.16);
}

TEST_F(KheperaPair, sensors_are_those_of_the_device) {
  begin();
  const auto other = client_of(wire::ir::kCode, 1);
  publish(wire::ir::kCode, wire::ir::kDataRanges,
          wire::ir::Data{{}, {0.02F, 0.05F, 0.01F, 1, 0.08F, 0.03F, 0.09F, 0.1F}});
  const auto data = latest<wire::ir::Data>(*other, wire::ir::kCode, wire::ir::kDataRanges, 0.3);
  ASSERT_EQ(data.ranges.size(), 8u);
  EXPECT_NEAR(data.ranges[0], 0.02, 0.001);
  EXPECT_NEAR(data.ranges[1], 0.05, 0.001);
  EXPECT_NEAR(data.ranges[3], 0.1, 0.001) << "it sees no further";
  EXPECT_EQ(data.voltages[2], 1000);
}

TEST_F(KheperaPair, a_command_from_before_the_robot_answers_is_carried_out) {
  ASSERT_EQ(build(R"(driver( name "khepera_emulator" port "/dev/robot" requires ["position2d:0"] ))"
                  "\n" +
                  std::string(kKheperaSection)),
            "");
  client = std::make_unique<server::TestClient>(network_, kPort);
  client->ask(server::mode_request(1));
  client->send(server::open_request(p2d::kCode, 1));
  client->send(drive_command(0.08, 0));
  network_.run_for(0.5);
  ASSERT_FALSE(wheels.commands.empty());
  EXPECT_NEAR(wanted().vel.px, 0.08, 1e-9);
}

TEST_F(KheperaPair, wheels_stop_when_the_last_client_has_gone_and_when_its_commander_is_silent) {
  begin(" watchdog 1");
  client->ask(drive_command(0.08, 0));
  network_.run_for(0.5);
  EXPECT_NEAR(wanted().vel.px, 0.08, 1e-9);
  network_.run_for(1);
  EXPECT_EQ(wanted().vel.px, 0);
  client->ask(drive_command(0.08, 0));
  network_.run_for(0.2);
  client->peer.reset();
  network_.run_for(0.2);
  EXPECT_EQ(wanted().vel.px, 0);
}

TEST_F(KheperaPair, a_line_that_was_pulled_is_waited_for_and_noise_loses_readings_alone) {
  begin(" reconnect 1");
  network_.serial().unplug("/dev/robot");
  network_.run_for(2);
  network_.serial().plug("/dev/robot");
  network_.run_for(4);
  network_.serial().faults = {.loss = 0.002, .change = 0.002};
  for (int turn = 0; turn < 20; ++turn) {
    client->ask(drive_command(0.08, 0));
    network_.run_for(0.5);
  }
  network_.serial().faults = {};
  client->ask(drive_command(0.16, 0));
  network_.run_for(0.3);
  EXPECT_NEAR(wanted().vel.px, 0.16, 1e-9);
}

TEST_F(KheperaPair, at_another_speed_nothing_answers) {
  begin("", " baud 9600");
  network_.run_for(4);
  EXPECT_EQ(server::outline(client->ask(server::open_request(p2d::kCode, 1))), "ACK 3, NACK 3");
}

/// As other drivers than ours speak to it.
TEST_F(KheperaPair, other_hosts_are_answered_as_the_maker_says) {
  ASSERT_EQ(build(R"(driver( name "khepera_emulator" port "/dev/robot" requires ["position2d:0"] ))"), "");
  struct HostEnd : net::SerialEvents {
    void received(std::span<const std::byte> news) override {
      for (const std::byte byte : news) text.push_back(static_cast<char>(byte));
    }
    void ended(const std::string&) override {}
    std::string text;
  } host;
  const auto line = *network_.open_serial("/dev/robot", {.baud = 38400});
  line->start(host);
  const auto ask = [&](std::string_view text, double seconds = 0.03) {
    line->send(std::as_bytes(std::span(text)));
    network_.run_for(seconds);
    return std::exchange(host.text, "");
  };
  EXPECT_EQ(ask("B\r"), "b,5.02,5.01\r\n");
  EXPECT_EQ(ask("\r\n"), "");
  EXPECT_EQ(ask("X\n"), "z,Command not found\r\n");
  EXPECT_EQ(ask("D,1\n"), "z,Protocol error\r\n");
  EXPECT_EQ(ask("G,100,-7\n"), "g\r\n");
  EXPECT_EQ(ask("H\n"), "h,100,-7\r\n");
  EXPECT_EQ(ask("D,-475,475\n"), "d\r\n");
  EXPECT_NEAR(wanted().vel.pa, 254 * 0.008 / 0.052, 1e-9) << "a wheel goes at 127 at most";
  EXPECT_EQ(ask("C,200,93\n", 0.1), "c\r\n");
  EXPECT_GT(wanted().vel.px, 0) << "on its way";
  publish(p2d::kCode, p2d::kDataState, p2d::Data{});
  network_.run_for(0.1);
  publish(p2d::kCode, p2d::kDataState, p2d::Data{{0.008, 0, 0}, {}, 0});
  EXPECT_EQ(ask("K\n", 0.2), "k,0,0,0,0,0,0\r\n");
  EXPECT_EQ(ask("K\n", 0.1), "k,1,0,0,1,0,0\r\n");
  EXPECT_EQ(wanted().vel.px, 0);
}

TEST_F(KheperaPair, sections_with_faults_say_what_is_valid) {
  EXPECT_EQ(build(R"(driver( name "khepera" provides ["position2d:1"] baud 12000 ))"),
            "test.cfg:1: baud is 9600, 19200 or 38400");
  EXPECT_EQ(build(R"(driver( name "khepera" provides ["sonar:0"] ))"),
            "test.cfg:1: driver \"khepera\" provides no such device as \"sonar:0\"; it has position2d, ir");
  ASSERT_EQ(build(kKheperaSection), "");
  client = client_of(p2d::kCode, 1);
  EXPECT_EQ(access, 3) << "no such port";
}

}  // namespace
}  // namespace playhouse::drivers
