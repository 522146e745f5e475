// The driver against a script that says what a robot said to the original driver, and against the emulator.

#include "playhouse/drivers/p2os/p2os.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "playhouse/drivers/hardware/testing_hardware.h"
#include "playhouse/wire/generated/bumper.h"
#include "playhouse/wire/generated/gripper.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/power.h"
#include "playhouse/wire/generated/sonar.h"

namespace playhouse::drivers {
namespace {

namespace p2d = wire::position2d;
using testing::FarEnd;
using testing::from_hex;
using testing::HardwareTest;
using testing::to_hex;

constexpr const char* kRobot = R"(driver( name "p2os" port "/dev/robot" )"
                               R"(provides ["position2d:1" "sonar:1" "power:1" "bumper:1" "gripper:1"] ))";
constexpr const char* kEmulator =
    R"(driver( name "p2os_emulator" port "/dev/robot" requires ["position2d:0" "sonar:0" "power:0" "bumper:0" "gripper:0"] ))";

Bytes drive(double speed, double turn_rate) {
  return server::message(wire::MessageType::kCmd, p2d::kCode, 1, p2d::kCmdVel,
                         wire::encode(p2d::CmdVel{{speed, 0, turn_rate}, 1}));
}

class P2osScript : public HardwareTest {
 protected:
  P2osScript() {
    std::string robot = kRobot;
    robot.insert(robot.size() - 1, " pulse 0");
    EXPECT_EQ(build(robot), "");
  }

  /// Answers as the robot of the capture did.
  void open() {
    client = client_of(p2d::kCode, 1);
    EXPECT_EQ(to_hex(robot.take()), "fa fb 03 00 00 00");
    robot.send(from_hex("fa fb 03 00 00 00"));
    EXPECT_EQ(to_hex(robot.take()), "fa fb 03 01 00 01");
    robot.send(from_hex("fa fb 03 01 00 01"));
    EXPECT_EQ(to_hex(robot.take()), "fa fb 03 02 00 02");
    robot.send(from_hex("fa fb 17 02 45 6d 75 00 50 69 6f 6e 65 65 72 00 70 33 64 78 2d 73 68 00 cc b9"));
    opened = to_hex(robot.take());
  }

  FarEnd robot{network_, "/dev/robot"};
  std::unique_ptr<server::TestClient> client;
  std::string opened;
};

TEST_F(P2osScript, starts_as_the_original_does) {
  open();
  EXPECT_EQ(access, 1);
  EXPECT_TRUE(opened.starts_with("fa fb 03 01 00 01 fa fb 03 00 00 00 fa fb 06 1c 3b 00 00 1c 3b")) << opened;
  EXPECT_TRUE(opened.ends_with("fa fb 06 04 3b 01 00 05 3b")) << "motors on: " << opened;
}

TEST_F(P2osScript, a_robot_that_is_still_open_is_closed_first) {
  client = client_of(p2d::kCode, 1);
  robot.take();
  robot.send(
      from_hex("fa fb 1b 32 00 00 00 00 00 00 00 00 00 00 7c 00 00 00 00 00 00 b5 00 00 00 66 0f 00 4d 8b"));
  EXPECT_EQ(to_hex(robot.take()), "fa fb 03 02 00 02");
  EXPECT_EQ(to_hex(robot.take(0.6)), "fa fb 03 00 00 00") << "and begins anew";
}

TEST_F(P2osScript, wheels_turn_as_with_the_original) {
  open();
  const auto wheels_of = [&](double speed, double turn_rate) {
    robot.send(p2os::encode_sip({.sonars = {}}));
    robot.take();
    client->ask(drive(speed, turn_rate));
    return to_hex(robot.take());
  };
  EXPECT_EQ(wheels_of(0.2, 0), "fa fb 06 20 3b 0a 0a 2a 45");
  EXPECT_EQ(wheels_of(2, 0), "fa fb 06 20 3b 19 19 39 54") << "500 mm/s";
  // The original cuts towards zero, here they are rounded: 14.5 and 5.5, -7.7 and -2.3.
  EXPECT_EQ(wheels_of(0.2, 0.5).substr(15, 5), "0e 06");
  EXPECT_EQ(wheels_of(-0.1, -0.3).substr(15, 5), "f8 fe");
  EXPECT_EQ(wheels_of(NAN, 0), "");
}

TEST_F(P2osScript, numbers_beyond_all_limits_are_at_the_limits) {
  open();
  const auto wheels_of = [&](double speed, double turn_rate) {
    robot.send(p2os::encode_sip({.sonars = {}}));
    robot.take();
    client->ask(drive(speed, turn_rate));
    return to_hex(robot.take()).substr(15, 5);
  };
  EXPECT_EQ(wheels_of(1e306, 0), "19 19");
  EXPECT_EQ(wheels_of(-1e308, 0), "e7 e7");
  EXPECT_EQ(wheels_of(0, 1e308), "19 e7");
}

/// 9600 baud have no time for more.
TEST_F(P2osScript, the_wheels_get_the_latest_command_with_each_packet) {
  open();
  client->ask(drive(0.1, 0));
  EXPECT_EQ(to_hex(robot.take()), "fa fb 06 20 3b 05 05 25 40") << "the first one at once";
  for (int k = 0; k < 50; ++k) client->ask(drive(0.2, 0));
  client->ask(drive(0, 0));
  EXPECT_EQ(to_hex(robot.take()), "");
  robot.send(p2os::encode_sip({.sonars = {}}));
  EXPECT_EQ(to_hex(robot.take()), "fa fb 06 20 3b 00 00 20 3b");
}

TEST_F(P2osScript, what_comes_before_the_robot_has_started_waits) {
  client = client_of(p2d::kCode, 1);
  for (const double speed : {0.1, 0.2}) client->ask(drive(speed, 0));
  EXPECT_TRUE(client->ask(question(p2d::kCode, p2d::kReqGetGeom, 1)).empty());
  robot.take();
  for (const char* const answer : {"fa fb 03 00 00 00", "fa fb 03 01 00 01"}) {
    robot.send(from_hex(answer));
    robot.take();
  }
  robot.send(p2os::encode_names({"small", "Pioneer", "amigo-sh"}));
  EXPECT_TRUE(to_hex(robot.take()).ends_with("fa fb 06 04 3b 01 00 05 3b fa fb 06 20 3b 0a 0a 2a 45"))
      << "motors, wheels";
  const std::vector<server::Received> answers = client->read();
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_NEAR(wire::decode<p2d::Geom>(answers[0].body)->size.sl, 0.33, 1e-9);
}

TEST_F(P2osScript, wheels_are_at_rest_when_the_last_words_of_a_client_were_a_command) {
  const auto sonar = client_of(wire::sonar::kCode, 1);
  open();
  robot.take();
  Bytes last = drive(0.2, 0);
  const Bytes close = server::open_request(p2d::kCode, 1, 2);
  last.insert(last.end(), close.begin(), close.end());
  client->ask(last);
  EXPECT_TRUE(to_hex(robot.take()).ends_with("fa fb 06 20 3b 00 00 20 3b fa fb 06 04 3b 00 00 04 3b"));
}

/// Frames of the capture, in which the original's client read 0.208, 0.034 and 0.454 rad (26 degrees) at the last one.
TEST_F(P2osScript, odometry_is_that_of_the_original_without_its_rounding) {
  open();
  for (const char* const packet :
       {"fa fb 1b 33 14 00 00 00 00 00 c8 00 c8 00 7c 00 00 00 00 00 00 b5 00 00 00 66 0f 00 50 2f",
        "fa fb 1b 33 3c 00 00 00 22 00 64 00 18 01 7c 00 00 00 00 00 00 b5 00 00 00 66 0f 00 50 65",
        "fa fb 1b 33 86 00 09 00 a3 00 64 00 18 01 7c 00 00 00 00 00 00 b5 00 00 00 66 0f 00 51 39",
        "fa fb 1b 33 d0 00 22 00 2b 01 64 00 18 01 7c 00 00 00 00 00 00 b5 00 00 00 66 0f 00 52 24"})
    robot.send(from_hex(packet));
  const auto state = latest<p2d::Data>(*client, p2d::kCode, p2d::kDataState, 0.2);
  EXPECT_NEAR(state.pos.px, 0.208 - 0.020, 1e-9) << "from the first packet on";
  EXPECT_NEAR(state.pos.py, 0.034, 1e-9);
  EXPECT_NEAR(state.pos.pa, 299 * 0.001534, 1e-9);
  EXPECT_NEAR(state.vel.px, 0.19, 1e-9);
  EXPECT_NEAR(state.vel.pa, 0.504, 1e-9);
}

TEST_F(P2osScript, counters_wrap_and_jumps_are_left_out) {
  open();
  const auto go = [&](int x, int y) {
    p2os::Sip sip{.sonars = {}};
    sip.x = static_cast<std::uint16_t>(x);
    sip.y = static_cast<std::uint16_t>(y);
    robot.send(p2os::encode_sip(sip));
    return latest<p2d::Data>(*client, p2d::kCode, p2d::kDataState, 0.2).pos;
  };
  go(4090, 10);
  EXPECT_NEAR(go(20, -6).px, 0.026, 1e-9);
  EXPECT_NEAR(go(270, -6).px, 0.026, 1e-9) << "the original leaves out 250 mm";
  EXPECT_NEAR(go(280, -6).px, 0.036, 1e-9);
  EXPECT_NEAR(go(280, -6).py, -0.016, 1e-9);
}

TEST_F(P2osScript, a_silent_robot_retires_with_its_devices) {
  open();
  client->read();
  network_.run_for(4);
  EXPECT_EQ(server::outline(client->ask(server::open_request(p2d::kCode, 1))), "ACK 3, NACK 3")
      << "the notice, and the answer";
}

TEST_F(P2osScript, ends_with_stop_motors_off_and_close) {
  open();
  client->ask(drive(0.2, 0));
  robot.take();
  client->peer.reset();
  EXPECT_EQ(to_hex(robot.take()),
            "fa fb 06 20 3b 00 00 20 3b fa fb 06 04 3b 00 00 04 3b fa fb 03 1d 00 1d fa fb 06 04 3b 00 00 04 "
            "3b fa fb 03 02 00 02");
}

class P2osPair : public HardwareTest {
 protected:
  server::FakeDriver& wheels = add_device(p2d::kCode);
  server::FakeDriver& sonar = add_device(wire::sonar::kCode);
  server::FakeDriver& power = add_device(wire::power::kCode);
  server::FakeDriver& bumper = add_device(wire::bumper::kCode);
  server::FakeDriver& gripper = add_device(wire::gripper::kCode);

  void begin(const std::string& more = "", const std::string& of_emulator = "") {
    std::string robot = kRobot, emulator = kEmulator;
    robot.insert(robot.size() - 1, more);
    emulator.insert(emulator.size() - 1, of_emulator);
    ASSERT_EQ(build(emulator + "\n" + robot), "");
    client = client_of(p2d::kCode, 1);
    network_.run_for(3);
  }
  p2d::CmdVel wanted() const { return *wire::decode<p2d::CmdVel>(wheels.commands.back().second); }

  std::unique_ptr<server::TestClient> client;
};

TEST_F(P2osPair, what_is_commanded_arrives_and_what_is_measured_comes_back) {
  begin();
  client->ask(drive(0.3, 0.4));
  network_.run_for(0.2);
  ASSERT_FALSE(wheels.commands.empty());
  EXPECT_NEAR(wanted().vel.px, 0.3, 0.01) << "of a wheel 20 mm/s are a unit";
  EXPECT_NEAR(wanted().vel.pa, 0.4, 0.056);
  publish(p2d::kCode, p2d::kDataState, p2d::Data{{1, 0, 0}, {}, 0});
  network_.run_for(0.3);
  publish(p2d::kCode, p2d::kDataState, p2d::Data{{1.05, 0.08, 0.3}, {0.2, 0, 0.1}, 1});
  const auto state = latest<p2d::Data>(*client, p2d::kCode, p2d::kDataState, 0.3);
  EXPECT_NEAR(state.pos.px, 0.05, 0.001) << "a jump of a metre is left out";
  EXPECT_NEAR(state.pos.py, 0.08, 0.001);
  EXPECT_NEAR(state.pos.pa, 0.3, 0.001);
  EXPECT_NEAR(state.vel.px, 0.2, 0.001);
  EXPECT_NEAR(state.vel.pa, 0.1, 0.006);
  EXPECT_EQ(state.stall, 1);
}

TEST_F(P2osPair, sensors_are_those_of_the_devices) {
  begin();
  std::vector<float> ranges;
  for (int i = 0; i < 16; ++i) ranges.push_back(static_cast<float>(0.5 + 0.25 * i));
  const auto other = client_of(wire::sonar::kCode, 1);
  publish(wire::sonar::kCode, wire::sonar::kDataRanges, wire::sonar::Data{ranges});
  const auto heard = latest<wire::sonar::Data>(*other, wire::sonar::kCode, wire::sonar::kDataRanges, 1);
  ASSERT_EQ(heard.ranges.size(), 16u);
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(heard.ranges[i], ranges[i], 0.001) << i;
  const auto geometry = wire::decode<wire::sonar::Geom>(
      other->ask(question(wire::sonar::kCode, wire::sonar::kReqGetGeom, 1)).back().body);
  ASSERT_EQ(geometry->poses.size(), 16u);
  EXPECT_NEAR(geometry->poses[3].px, 0.166, 1e-9);

  const auto volts = client_of(wire::power::kCode, 1);
  publish(wire::power::kCode, wire::power::kDataState, wire::power::Data{.valid = 1, .volts = 11.3F});
  EXPECT_NEAR(latest<wire::power::Data>(*volts, wire::power::kCode, wire::power::kDataState, 0.3).volts, 11.3,
              0.05);

  const auto touch = client_of(wire::bumper::kCode, 1);
  const std::vector<std::uint8_t> pressed = {1, 0, 0, 1, 0, 0, 0, 0, 0, 1};
  publish(wire::bumper::kCode, wire::bumper::kDataState, wire::bumper::Data{pressed});
  EXPECT_EQ(latest<wire::bumper::Data>(*touch, wire::bumper::kCode, wire::bumper::kDataState, 0.3).bumpers,
            pressed);
}

TEST_F(P2osPair, the_gripper_obeys_and_tells) {
  namespace grp = wire::gripper;
  begin();
  const auto other = client_of(grp::kCode, 1);
  other->ask(bare_command(grp::kCode, grp::kCmdClose, 1));
  network_.run_for(0.2);
  ASSERT_EQ(gripper.commands.size(), 1u);
  EXPECT_EQ(gripper.commands[0].first, grp::kCmdClose);
  publish(grp::kCode, grp::kDataState, grp::Data{.state = grp::kStateClosed, .beams = 4});
  const auto state = latest<grp::Data>(*other, grp::kCode, grp::kDataState, 0.3);
  EXPECT_EQ(state.state, grp::kStateClosed);
  EXPECT_EQ(state.beams, 4u);
}

TEST_F(P2osPair, without_motors_it_does_not_move) {
  begin();
  client->ask(request(p2d::kCode, p2d::kReqMotorPower, p2d::PowerConfig{0}, 1));
  client->ask(drive(0.3, 0));
  network_.run_for(0.2);
  EXPECT_EQ(wanted().vel.px, 0);
  client->ask(request(p2d::kCode, p2d::kReqMotorPower, p2d::PowerConfig{1}, 1));
  client->ask(drive(0.3, 0));
  network_.run_for(0.2);
  EXPECT_NEAR(wanted().vel.px, 0.3, 0.01);
}

TEST_F(P2osPair, wheels_stop_when_the_last_client_has_gone_and_when_its_commander_is_silent) {
  begin(" watchdog 1");
  client->ask(drive(0.3, 0));
  network_.run_for(0.5);
  EXPECT_NEAR(wanted().vel.px, 0.3, 0.01);
  network_.run_for(1);
  EXPECT_EQ(wanted().vel.px, 0);
  client->ask(drive(0.3, 0));
  network_.run_for(0.2);
  client->peer.reset();
  network_.run_for(0.2);
  EXPECT_EQ(wanted().vel.px, 0);
}

TEST_F(P2osPair, the_robot_stops_when_its_line_is_pulled_and_the_driver_waits_for_it) {
  begin(" reconnect 1");
  client->ask(drive(0.3, 0));
  network_.run_for(0.2);
  network_.serial().unplug("/dev/robot");
  network_.run_for(2.5);
  EXPECT_EQ(wanted().vel.px, 0) << "the robot's own watchdog";
  network_.serial().plug("/dev/robot");
  network_.run_for(5);
  client->ask(drive(0.2, 0));
  network_.run_for(0.2);
  EXPECT_NEAR(wanted().vel.px, 0.2, 0.01);
}

TEST_F(P2osPair, a_robot_at_another_speed_is_found) {
  begin("", " baud 19200");
  network_.run_for(10);
  client->ask(drive(0.2, 0));
  network_.run_for(0.2);
  ASSERT_FALSE(wheels.commands.empty());
  EXPECT_NEAR(wanted().vel.px, 0.2, 0.01);
}

TEST_F(P2osPair, a_robot_at_another_speed_is_found_again_at_once) {
  begin(" reconnect 1", " baud 38400");
  network_.run_for(5);
  client->peer.reset();
  network_.run_for(1);
  client = client_of(p2d::kCode, 1);
  network_.run_for(2);
  client->ask(drive(0.2, 0));
  network_.run_for(0.3);
  EXPECT_NEAR(wanted().vel.px, 0.2, 0.01);
}

TEST_F(P2osPair, a_pose_that_was_set_ends_with_the_last_client) {
  begin();
  const auto pose = [this] { return latest<p2d::Data>(*client, p2d::kCode, p2d::kDataState, 0.3).pos; };
  client->ask(request(p2d::kCode, p2d::kReqSetOdom, p2d::SetOdomReq{{7, 8, 1}}, 1));
  EXPECT_NEAR(pose().px, 7, 0.001);
  client->peer.reset();
  network_.run_for(1);
  client = client_of(p2d::kCode, 1);
  network_.run_for(2);
  EXPECT_NEAR(pose().px, 0, 0.001);
}

TEST_F(P2osPair, a_fast_robot_is_followed) {
  begin(" max_xspeed 1.5");
  for (int cycle = 0; cycle <= 20; ++cycle) {
    publish(p2d::kCode, p2d::kDataState, p2d::Data{{0.14 * cycle, 0, 0}, {1.4, 0, 0}, 0});
    network_.run_for(0.1);
  }
  EXPECT_NEAR(latest<p2d::Data>(*client, p2d::kCode, p2d::kDataState, 0.3).pos.px, 2.8, 0.15);
}

TEST_F(P2osPair, half_a_frame_and_an_end_do_not_matter) {
  ASSERT_EQ(build(kEmulator), "");
  {
    auto line = *network_.open_serial("/dev/robot", {});
    line->send(from_hex("fa fb f9 00 fa fb"));
    network_.run_for(1);
    line->send(p2os::encode_command(p2os::kSync0));
    network_.run_for(1);
    for (const RawBytes& bytes : {p2os::encode_command(p2os::kSync1), p2os::encode_command(p2os::kSync2),
                                  p2os::encode_command(p2os::kOpen), p2os::encode_command(p2os::kEnable, 1),
                                  p2os::encode_command_of_bytes(p2os::kWheels, 10, 10)})
      line->send(bytes);
    network_.run_for(0.5);
  }
  ASSERT_FALSE(wheels.commands.empty());
  EXPECT_NEAR(wanted().vel.px, 0.2, 0.01);
  drivers.back()->finish();
  EXPECT_EQ(wanted().vel.px, 0) << "the program has ended";
}

TEST_F(P2osPair, a_noisy_line_loses_packets_and_nothing_else) {
  begin();
  network_.serial().faults = {.loss = 0.003, .change = 0.003};
  double x = 0;
  for (int cycle = 0; cycle < 300; ++cycle) {
    x += 0.02;
    publish(p2d::kCode, p2d::kDataState, p2d::Data{{x, 0, 0}, {0.2, 0, 0}, 0});
    if (cycle % 10 == 0) client->ask(drive(0.2, 0));
    network_.run_for(0.1);
  }
  network_.serial().faults = {};
  client->ask(drive(0.1, 0));
  const auto state = latest<p2d::Data>(*client, p2d::kCode, p2d::kDataState, 0.5);
  EXPECT_NEAR(wanted().vel.px, 0.1, 0.01);
  EXPECT_GT(state.pos.px, 5) << "of 6 m, as a longer gap is taken for a fault";
  EXPECT_LT(state.pos.px, 6.1);
}

TEST_F(P2osPair, a_port_that_is_not_there_is_one_clear_answer) {
  ASSERT_EQ(build(kRobot), "");
  client = client_of(p2d::kCode, 1);
  EXPECT_EQ(access, 3);
}

TEST_F(P2osPair, sections_with_faults_say_what_is_valid) {
  const auto fault = [this](const std::string& section) { return build("driver( name " + section + " )"); };
  EXPECT_EQ(
      fault(R"("p2os" provides ["laser:0"])"),
      "test.cfg:1: driver \"p2os\" provides no such device as \"laser:0\"; it has odometry:::position2d, "
      "compass:::position2d, power, sonar, bumper, gripper, dio, aio");
  EXPECT_EQ(fault(R"("p2os" provides ["position2d:1"] port "COM1")"),
            "test.cfg:1: port is a serial port, \"/dev/ttyUSB0\", or \"tcp:HOST:PORT\"");
  EXPECT_EQ(fault(R"("p2os" provides ["position2d:1"] port "tcp:lab:70000")"),
            "test.cfg:1: port is \"tcp:HOST:PORT\" of a host and a port from 1 to 65535");
  EXPECT_EQ(fault(R"("p2os_emulator" requires ["position2d:0"])"),
            "test.cfg:1: port or tcp_port is needed, and one of them alone");
  EXPECT_EQ(fault(R"("p2os_emulator" requires ["position2d:0"] port "/dev/robot" robot "p4")"),
            "test.cfg:1: robot is a subclass such as p3dx-sh, p3at-sh or amigo-sh, not \"p4\"");
}

}  // namespace
}  // namespace playhouse::drivers
