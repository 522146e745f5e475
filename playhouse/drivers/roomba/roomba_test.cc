// The driver against a script that says what a robot said to the original driver, and against the emulator.

#include "playhouse/drivers/roomba/roomba.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "playhouse/drivers/hardware/testing_hardware.h"
#include "playhouse/wire/generated/bumper.h"
#include "playhouse/wire/generated/gripper.h"
#include "playhouse/wire/generated/ir.h"
#include "playhouse/wire/generated/opaque.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/power.h"

namespace playhouse::drivers {
namespace {

namespace p2d = wire::position2d;
using testing::FarEnd;
using testing::from_hex;
using testing::HardwareTest;
using testing::to_hex;

constexpr const char* kCleaner =
    R"(driver( name "roomba" port "/dev/robot" )"
    R"(provides ["position2d:1" "power:1" "bumper:1" "ir:1" "opaque:1" "gripper:1"] ))";
constexpr const char* kAsk = "8e 00";
constexpr const char* kStill =
    "00 00 00 00 00 00 00 00 00 00 ff 00 00 00 00 00 00 3e 80 fe a2 19 09 60 0a 8c";

std::string with(std::string section, const std::string& more) {
  return section.insert(section.size() - 1, more);
}
Bytes drive_command(double speed, double turn_rate) {
  return server::message(wire::MessageType::kCmd, p2d::kCode, 1, p2d::kCmdVel,
                         wire::encode(p2d::CmdVel{{speed, 0, turn_rate}, 1}));
}

class RoombaScript : public HardwareTest {
 protected:
  void begin(const std::string& more = "") {
    ASSERT_EQ(build(with(kCleaner, more)), "");
    client = client_of(p2d::kCode, 1);
    started = to_hex(robot.take(0.25));
  }
  void wait_for_question() {
    for (int round = 0; round < 40; ++round)
      if (to_hex(robot.take(0.005)).ends_with(kAsk)) return;
    ADD_FAILURE() << "it does not ask";
  }
  /// The answer to the next question.
  p2d::Data answer(const std::string& hex) {
    wait_for_question();
    robot.send(from_hex(hex));
    return latest<p2d::Data>(*client, p2d::kCode, p2d::kDataState, 0.04);
  }
  /// Of the command for the wheels; a command goes with a question.
  std::string wheels_of(double speed, double turn_rate) {
    wait_for_question();
    client->ask(drive_command(speed, turn_rate));
    const std::string sent = to_hex(robot.take(0.03));
    const std::size_t at = sent.find("89");
    return at == std::string::npos ? "" : sent.substr(at, 14);
  }

  FarEnd robot{network_, "/dev/robot", {.baud = 57600}};
  std::unique_ptr<server::TestClient> client;
  std::string started;
};

TEST_F(RoombaScript, starts_as_the_original_does) {
  begin();
  EXPECT_EQ(access, 1);
  EXPECT_TRUE(started.starts_with("80 82 8e 00")) << started;
}

TEST_F(RoombaScript, without_safety_it_goes_on_to_the_full_mode) {
  begin(" safe 0");
  EXPECT_TRUE(started.starts_with("80 82 84 8e 00")) << started;
}

TEST_F(RoombaScript, odometry_adds_up_what_the_robot_tells_and_leaves_out_what_was_before) {
  begin();
  answer("00 00 00 00 00 00 00 00 00 00 ff 00 03 e8 00 00 00 3e 80 fe a2 19 09 60 0a 8c");
  answer("00 00 00 00 00 00 00 00 00 00 ff 00 00 28 00 00 00 3e 80 fe a2 19 09 60 0a 8c");
  EXPECT_NEAR(answer("00 00 00 00 00 00 00 00 00 00 ff 00 00 28 00 00 00 3e 80 fe a2 19 09 60 0a 8c").pos.px,
              0.08, 1e-9);
  const auto turned =
      answer("00 00 00 00 00 00 00 00 00 00 ff 00 00 00 00 40 00 3e 80 fe a2 19 09 60 0a 8c").pos;
  EXPECT_NEAR(turned.pa, 64 * 2 / 258.0, 1e-9);
  const auto back =
      answer("00 00 00 00 00 00 00 00 00 00 ff 00 ff d8 00 00 00 3e 80 fe a2 19 09 60 0a 8c").pos;
  EXPECT_NEAR(back.px, 0.08 - 0.04 * std::cos(turned.pa), 1e-9);
  EXPECT_NEAR(back.py, -0.04 * std::sin(turned.pa), 1e-9);
}

TEST_F(RoombaScript, power_bumpers_and_switches_are_what_the_bytes_say) {
  begin();
  const auto power = client_of(wire::power::kCode, 1), bumper = client_of(wire::bumper::kCode, 1);
  const auto ir = client_of(wire::ir::kCode, 1), opaque = client_of(wire::opaque::kCode, 1);
  answer("12 01 00 01 00 00 01 00 07 09 82 04 00 00 00 00 02 3e 80 fe a2 19 09 60 0a 8c");
  const auto battery = latest<wire::power::Data>(*power, wire::power::kCode, wire::power::kDataState, 0);
  EXPECT_NEAR(battery.volts, 16, 1e-5);
  EXPECT_NEAR(battery.percent, 88.8889, 1e-3);
  EXPECT_NEAR(battery.watts, 5.6, 1e-5) << "drawn; the original has the sign of the current";
  EXPECT_NEAR(battery.joules, 2.4 * 3600 * 16, 1) << "the original has Ah";
  EXPECT_EQ(battery.charging, 1);
  EXPECT_EQ(battery.valid, 31u);
  EXPECT_EQ(latest<wire::bumper::Data>(*bumper, wire::bumper::kCode, wire::bumper::kDataState, 0).bumpers,
            (std::vector<std::uint8_t>{1, 0}));
  EXPECT_EQ(latest<wire::ir::Data>(*ir, wire::ir::kCode, wire::ir::kDataRanges, 0).ranges,
            (std::vector<float>{1, 0, 1, 0, 0, 1, 9, 7, 1, 0, 0}));
  EXPECT_EQ(latest<wire::opaque::Data>(*opaque, wire::opaque::kCode, wire::opaque::kDataState, 0).data,
            (std::vector<std::uint8_t>{0, 0, 1, 0, 0x82}));
}

TEST_F(RoombaScript, songs_lights_and_brushes_are_sent_as_by_the_original) {
  begin();
  const auto other = client_of(wire::opaque::kCode, 1), gripper = client_of(wire::gripper::kCode, 1);
  const auto sent_for = [&](const std::string& hex) {
    wait_for_question();
    wire::opaque::Data data;
    for (const std::byte byte : from_hex(hex)) data.data.push_back(static_cast<std::uint8_t>(byte));
    other->ask(command(wire::opaque::kCode, wire::opaque::kCmdData, data, 1));
    return to_hex(robot.take(0.05));
  };
  EXPECT_EQ(sent_for("01 02 03 3c 10 3e 10 40 20"), "8c 02 03 3c 10 3e 10 40 20");
  EXPECT_EQ(sent_for("00 02"), "8d 02");
  EXPECT_EQ(sent_for("02 01 00 01 00 02 80 ff"), "8b 25 80 ff");
  EXPECT_EQ(sent_for("01 02 03 3c 10"), "") << "shorter than it says";
  EXPECT_EQ(sent_for("03 04"), "") << "a Roomba has no demos";
  wait_for_question();
  gripper->ask(bare_command(wire::gripper::kCode, wire::gripper::kCmdOpen, 1));
  EXPECT_EQ(to_hex(robot.take(0.05)).substr(0, 5), "8a 07");
  wait_for_question();
  gripper->ask(bare_command(wire::gripper::kCode, wire::gripper::kCmdClose, 1));
  EXPECT_EQ(to_hex(robot.take(0.05)).substr(0, 5), "8a 00");
}

/// In the original one byte more shifts all packets for ever, and one less stops it.
TEST_F(RoombaScript, a_byte_more_or_less_costs_one_packet) {
  begin();
  answer(kStill);
  EXPECT_EQ(answer(std::string(kStill).substr(0, 25 * 3 - 1)).pos.px, 0) << "no data";
  answer(std::string("28 ") + kStill);
  const auto state = answer("00 00 00 00 00 00 00 00 00 00 ff 00 00 28 00 00 00 3e 80 fe a2 19 09 60 0a 8c");
  EXPECT_NEAR(state.pos.px, 0.04, 1e-9);
  EXPECT_NEAR(state.vel.px, 0.04 / 0.3, 1e-9) << "over three questions";
}

TEST_F(RoombaScript, safe_mode_is_asked_for_again_after_a_cliff) {
  begin();
  answer(kStill);
  answer("00 00 01 00 00 00 00 00 00 00 ff 00 00 00 00 00 00 3e 80 fe a2 19 09 60 0a 8c");
  wait_for_question();
  robot.send(from_hex(kStill));
  EXPECT_EQ(to_hex(robot.take(0.04)), "82");
}

TEST_F(RoombaScript, with_bumplock_it_stops_and_goes_back_alone) {
  begin(" bumplock 1");
  answer(kStill);
  wait_for_question();
  robot.send(from_hex("01 00 00 00 00 00 00 00 00 00 ff 00 00 00 00 00 00 3e 80 fe a2 19 09 60 0a 8c"));
  EXPECT_EQ(to_hex(robot.take(0.04)), "89 00 00 80 00");
  EXPECT_EQ(wheels_of(0.2, 0.3), "89 00 00 80 00");
  EXPECT_EQ(wheels_of(-0.1, 0.3), "89 ff 9c 80 00");
  answer(kStill);
  EXPECT_EQ(wheels_of(0.2, 0), "89 00 c8 80 00");
  EXPECT_EQ(wheels_of(NAN, 0), "");
}

TEST_F(RoombaScript, beyond_all_limits_it_is_as_fast_as_it_can) {
  begin();
  EXPECT_EQ(wheels_of(1e300, 0), "89 01 f4 80 00");
  EXPECT_EQ(wheels_of(-1e300, 0), "89 fe 0c 80 00");
  EXPECT_EQ(wheels_of(0, 1e300), "89 01 f4 00 01");
}

TEST_F(RoombaScript, of_many_commands_between_two_questions_the_last_one_is_sent_with_the_next) {
  begin();
  EXPECT_EQ(wheels_of(0.1, 0), "89 00 64 80 00") << "there was none since the question";
  for (const double speed : {0.2, 0.3, 0.4}) client->ask(drive_command(speed, 0));
  EXPECT_EQ(to_hex(robot.take(0.1)), "89 01 90 80 00 8e 00");
}

TEST_F(RoombaScript, a_silent_robot_retires_with_its_devices) {
  begin();
  client->read();
  network_.run_for(4);
  EXPECT_EQ(server::outline(client->ask(server::open_request(p2d::kCode, 1))), "ACK 3, NACK 3")
      << "the notice, and the answer";
}

TEST_F(RoombaScript, ends_with_the_wheels_and_the_brushes_off) {
  begin();
  const auto gripper = client_of(wire::gripper::kCode, 1);
  gripper->ask(bare_command(wire::gripper::kCode, wire::gripper::kCmdOpen, 1));
  robot.take(0.1);
  gripper->peer.reset();
  EXPECT_NE(to_hex(robot.take(0.05)).find("8a 00"), std::string::npos);
  client->peer.reset();
  EXPECT_TRUE(to_hex(robot.take(0.05)).ends_with("89 00 00 80 00"));
}

class RoombaPair : public HardwareTest {
 protected:
  server::FakeDriver& wheels = add_device(p2d::kCode);
  server::FakeDriver& bumper = add_device(wire::bumper::kCode);
  server::FakeDriver& power = add_device(wire::power::kCode);
  server::FakeDriver& ir = add_device(wire::ir::kCode);
  server::FakeDriver& gripper = add_device(wire::gripper::kCode);

  void begin(const std::string& more = "", const std::string& of_emulator = "",
             const std::string& driver = kCleaner) {
    const std::string emulator = R"(driver( name "roomba_emulator" port "/dev/robot" )"
                                 R"(requires ["position2d:0" "bumper:0" "power:0" "ir:0" "gripper:0"] ))";
    ASSERT_EQ(build(with(emulator, of_emulator) + "\n" + with(driver, more)), "");
    client = client_of(p2d::kCode, 1);
    network_.run_for(0.5);
  }
  p2d::CmdVel wanted() const { return *wire::decode<p2d::CmdVel>(wheels.commands.back().second); }
  void stand(const wire::Pose2d& pose, std::uint8_t stall = 0) {
    publish(p2d::kCode, p2d::kDataState, p2d::Data{pose, {}, stall});
    network_.run_for(0.3);
  }
  p2d::Data state() { return latest<p2d::Data>(*client, p2d::kCode, p2d::kDataState, 0.3); }

  std::unique_ptr<server::TestClient> client;
};

/// Of each generation: a driver drives what stands for it, within a millimetre and a unit of the angle.
class EachGeneration : public RoombaPair, public ::testing::WithParamInterface<int> {
 protected:
  void begin_generation() {
    const std::string create = with(kCleaner, "").replace(std::string(kCleaner).find("roomba"), 6, "create");
    if (GetParam() == 0) begin();
    if (GetParam() == 1) begin(" roomba500 1", R"( generation "roomba500")");
    if (GetParam() == 2) begin("", R"( generation "create")", create);
  }
};

TEST_P(EachGeneration, what_is_commanded_arrives_and_what_is_measured_comes_back) {
  begin_generation();
  client->ask(drive_command(0.2, 0.5));
  network_.run_for(0.1);
  ASSERT_FALSE(wheels.commands.empty());
  EXPECT_NEAR(wanted().vel.px, 0.2, 0.001);
  EXPECT_NEAR(wanted().vel.pa, 0.5, 0.002);
  client->ask(drive_command(0, -0.7));
  network_.run_for(0.1);
  EXPECT_NEAR(wanted().vel.px, 0, 1e-9);
  EXPECT_NEAR(wanted().vel.pa, -0.7, 0.01);

  stand({3, 4, 1});
  state();
  double x = 3, y = 4, a = 1;
  for (int step = 0; step < 20; ++step) {
    a += 0.1;
    x += 0.05 * std::cos(a - 0.05);
    y += 0.05 * std::sin(a - 0.05);
    stand({x, y, a});
  }
  const auto now = state();
  const double c = std::cos(1), s = std::sin(1);
  EXPECT_NEAR(now.pos.pa, 2, 0.02);
  EXPECT_NEAR(now.pos.px, c * (x - 3) + s * (y - 4), 0.02) << "from where it was first";
  EXPECT_NEAR(now.pos.py, -s * (x - 3) + c * (y - 4), 0.02);
}

INSTANTIATE_TEST_SUITE_P(Of, EachGeneration, ::testing::Values(0, 1, 2));

TEST_F(RoombaPair, fractions_of_a_millimetre_add_up) {
  begin();
  stand({0, 0, 0});
  state();
  for (int step = 1; step <= 100; ++step) stand({0.0004 * step, 0, 0});
  EXPECT_NEAR(state().pos.px, 0.04, 0.001);
}

TEST_F(RoombaPair, sensors_are_those_of_the_devices) {
  begin();
  const auto battery = client_of(wire::power::kCode, 1), touch = client_of(wire::bumper::kCode, 1),
             switches = client_of(wire::ir::kCode, 1);
  publish(wire::power::kCode, wire::power::kDataState,
          wire::power::Data{.valid = 11, .volts = 14.5F, .percent = 50, .watts = 29});
  publish(wire::bumper::kCode, wire::bumper::kDataState, wire::bumper::Data{{0, 0, 0, 1}});
  const std::vector<float> told = {1, 0, 0, 0, 0, 1, 20, 10, 0, 0, 0};
  publish(wire::ir::kCode, wire::ir::kDataRanges, wire::ir::Data{{}, told});
  network_.run_for(0.3);
  const auto power_now = latest<wire::power::Data>(*battery, wire::power::kCode, wire::power::kDataState, 0);
  EXPECT_NEAR(power_now.volts, 14.5, 0.001);
  EXPECT_NEAR(power_now.percent, 50, 0.04);
  EXPECT_NEAR(power_now.watts, 29, 0.02);
  EXPECT_EQ(latest<wire::bumper::Data>(*touch, wire::bumper::kCode, wire::bumper::kDataState, 0).bumpers,
            (std::vector<std::uint8_t>{0, 1}));
  EXPECT_EQ(latest<wire::ir::Data>(*switches, wire::ir::kCode, wire::ir::kDataRanges, 0).ranges, told);
  stand({0, 0, 0}, 1);
  EXPECT_EQ(state().stall, 1);
}

TEST_F(RoombaPair, at_a_cliff_it_stops_and_obeys_again_once_the_cliff_is_gone) {
  begin();
  client->ask(drive_command(0.2, 0));
  network_.run_for(0.1);
  EXPECT_NEAR(wanted().vel.px, 0.2, 1e-9);
  publish(wire::ir::kCode, wire::ir::kDataRanges, wire::ir::Data{{}, {0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0}});
  network_.run_for(0.3);
  EXPECT_EQ(wanted().vel.px, 0);
  client->ask(drive_command(0.2, 0));
  network_.run_for(0.1);
  EXPECT_EQ(wanted().vel.px, 0) << "passive";
  publish(wire::ir::kCode, wire::ir::kDataRanges, wire::ir::Data{{}, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}});
  network_.run_for(0.3);
  client->ask(drive_command(0.2, 0));
  network_.run_for(0.1);
  EXPECT_NEAR(wanted().vel.px, 0.2, 1e-9);
}

TEST_F(RoombaPair, an_ir_of_another_kind_is_no_cliff) {
  begin();
  publish(wire::ir::kCode, wire::ir::kDataRanges, wire::ir::Data{{}, {1, 1, 1, 1, 1, 1, 1, 1}});
  network_.run_for(0.3);
  client->ask(drive_command(0.2, 0));
  network_.run_for(0.1);
  EXPECT_NEAR(wanted().vel.px, 0.2, 1e-9);
}

TEST_F(RoombaPair, brushes_are_the_gripper) {
  begin();
  const auto other = client_of(wire::gripper::kCode, 1);
  other->ask(bare_command(wire::gripper::kCode, wire::gripper::kCmdOpen, 1));
  network_.run_for(0.1);
  ASSERT_FALSE(gripper.commands.empty());
  EXPECT_EQ(gripper.commands.back().first, wire::gripper::kCmdOpen);
}

TEST_F(RoombaPair, wheels_stop_when_the_last_client_has_gone_and_when_its_commander_is_silent) {
  begin(" watchdog 1");
  client->ask(drive_command(0.3, 0));
  network_.run_for(0.5);
  EXPECT_NEAR(wanted().vel.px, 0.3, 1e-9);
  network_.run_for(1);
  EXPECT_EQ(wanted().vel.px, 0);
  client->ask(drive_command(0.3, 0));
  network_.run_for(0.2);
  client->peer.reset();
  network_.run_for(0.2);
  EXPECT_EQ(wanted().vel.px, 0);
}

TEST_F(RoombaPair, a_command_from_before_the_robot_answers_is_carried_out) {
  ASSERT_EQ(build(R"(driver( name "roomba_emulator" port "/dev/robot" requires ["position2d:0"] ))"
                  "\n" +
                  std::string(kCleaner)),
            "");
  client = std::make_unique<server::TestClient>(network_, kPort);
  client->ask(server::mode_request(1));
  client->send(server::open_request(p2d::kCode, 1));
  client->send(drive_command(0.2, 0));
  network_.run_for(0.5);
  ASSERT_FALSE(wheels.commands.empty());
  EXPECT_NEAR(wanted().vel.px, 0.2, 1e-9);
}

TEST_F(RoombaPair, a_line_that_was_pulled_is_waited_for) {
  begin(" reconnect 1");
  network_.serial().unplug("/dev/robot");
  network_.run_for(2);
  network_.serial().plug("/dev/robot");
  network_.run_for(5);
  client->ask(drive_command(0.2, 0));
  network_.run_for(0.2);
  EXPECT_NEAR(wanted().vel.px, 0.2, 1e-9);
}

TEST_F(RoombaPair, without_reconnect_the_devices_retire_with_the_line) {
  begin();
  network_.serial().unplug("/dev/robot");
  network_.run_for(0.5);
  client->read();
  EXPECT_EQ(server::outline(client->ask(server::open_request(p2d::kCode, 1))), "NACK 3");
}

TEST_F(RoombaPair, at_another_speed_nothing_is_taken_for_an_answer) {
  begin("", " baud 19200");
  network_.run_for(4);
  EXPECT_EQ(server::outline(client->ask(server::open_request(p2d::kCode, 1))), "ACK 3, NACK 3");
}

TEST_F(RoombaPair, a_noisy_line_loses_packets_and_the_way_in_them) {
  begin();
  stand({0, 0, 0});
  network_.serial().faults = {.loss = 0.002, .change = 0};
  for (int step = 1; step <= 100; ++step) stand({0.01 * step, 0, 0});
  network_.serial().faults = {};
  const auto now = state();
  EXPECT_GT(now.pos.px, 0.7);
  EXPECT_LT(now.pos.px, 1.01);
  client->ask(drive_command(0.1, 0));
  network_.run_for(0.2);
  EXPECT_NEAR(wanted().vel.px, 0.1, 1e-9);
}

TEST_F(RoombaPair, a_port_that_is_not_there_is_one_clear_answer) {
  ASSERT_EQ(build(kCleaner), "");
  client = client_of(p2d::kCode, 1);
  EXPECT_EQ(access, 3);
}

/// As other drivers than ours speak to it.
class RoombaHost : public HardwareTest {
 protected:
  server::FakeDriver& wheels = add_device(p2d::kCode);

  void begin(const std::string& generation, int baud) {
    ASSERT_EQ(
        build(R"(driver( name "roomba_emulator" port "/dev/robot" requires ["position2d:0"] generation ")" +
              generation + "\" )"),
        "");
    port = std::make_unique<HostEnd>(network_, baud);
  }
  std::string ask(const std::string& hex, double seconds = 0.01) {
    port->line->send(from_hex(hex));
    network_.run_for(seconds);
    return to_hex(std::exchange(port->bytes, {}));
  }
  p2d::CmdVel wanted() const {
    return wheels.commands.empty() ? p2d::CmdVel{}
                                   : *wire::decode<p2d::CmdVel>(wheels.commands.back().second);
  }

  struct HostEnd : net::SerialEvents {
    HostEnd(net::SimulatedNetwork& network, int baud)
        : line(*network.open_serial("/dev/robot", {.baud = baud})) {
      line->start(*this);
    }
    void received(std::span<const std::byte> news) override {
      bytes.insert(bytes.end(), news.begin(), news.end());
    }
    void ended(const std::string&) override {}
    std::unique_ptr<net::SerialLine> line;
    RawBytes bytes;
  };
  std::unique_ptr<HostEnd> port;
};

TEST_F(RoombaHost, modes_are_those_of_the_sci) {
  begin("roomba", 57600);
  EXPECT_EQ(ask("8e 03"), "") << "off";
  EXPECT_EQ(ask("80 8e 03"), "00 3e 80 fe a2 19 0a 8c 0a 8c");
  ask("84 89 00 c8 80 00");
  EXPECT_EQ(wanted().vel.px, 0) << "full mode follows safe mode alone";
  ask("82 89 00 c8 80 00");
  EXPECT_NEAR(wanted().vel.px, 0.2, 1e-9);
  ask("80");
  EXPECT_EQ(wanted().vel.px, 0);
  EXPECT_EQ(ask("8e 23"), "") << "no mode packet, and no answer";
}

TEST_F(RoombaHost, the_create_answers_lists_and_streams_and_drives_wheels) {
  begin("create", 57600);
  EXPECT_EQ(ask("80 83 95 02 23 18"), "02 19") << "safe mode; 25 degrees";
  ask("91 00 64 00 c8");
  EXPECT_NEAR(wanted().vel.px, 0.15, 1e-9);
  EXPECT_NEAR(wanted().vel.pa, -0.1 / 0.258, 1e-9) << "the right wheel goes at 0.1 m/s";
  EXPECT_EQ(ask("95 02 29 2a"), "00 64 00 c8");
  const std::string streamed = ask("94 02 23 07", 0.05);
  EXPECT_EQ(streamed.substr(0, 20), "13 04 23 02 07 00 d0") << streamed;
  EXPECT_NE(streamed.find("13 04", 5), std::string::npos) << "every 15 ms";
  ask("96 00", 0.05);
  EXPECT_EQ(ask("98 02 9b 05 9a"), "02 9b 05");
}

TEST_F(RoombaHost, half_a_command_is_forgotten_after_a_pause) {
  begin("roomba", 57600);
  ask("80 82 89 00", 1);
  ask("89 00 c8 80 00");
  EXPECT_NEAR(wanted().vel.px, 0.2, 1e-9);
  ask("89 01", 0.1);
  ask("90 80 00");
  EXPECT_NEAR(wanted().vel.px, 0.4, 1e-9) << "a pause of a tenth is none";
}

TEST_F(RoombaHost, a_song_plays_as_long_as_it_is) {
  begin("create", 57600);
  ask("80 84 8c 03 01 3c 20 8d 03");
  EXPECT_EQ(ask("95 02 24 25"), "03 01");
  EXPECT_EQ(ask("95 02 24 25", 0.6).substr(0, 5), "03 01");
  EXPECT_EQ(ask("95 02 24 25"), "03 00") << "half a second is over";
}

TEST_F(RoombaHost, the_500_series_counts_its_wheels) {
  begin("roomba500", 115200);
  publish(p2d::kCode, p2d::kDataState, p2d::Data{});
  ask("80 83", 0.1);
  publish(p2d::kCode, p2d::kDataState, p2d::Data{{0.4446, 0, 0}, {}, 0});
  network_.run_for(0.1);
  EXPECT_EQ(ask("95 02 2b 2c"), "03 e8 03 e8") << "1000 counts of 0.4446 mm";
  EXPECT_EQ(ask("95 01 13"), "01 bc");
  EXPECT_EQ(ask("8e 64").size(), 80u * 3 - 1);
}

TEST_F(RoombaHost, sections_with_faults_say_what_is_valid) {
  EXPECT_EQ(
      build(
          R"(driver( name "roomba_emulator" port "/dev/robot" requires ["position2d:0"] generation "r2d2" ))"),
      "test.cfg:1: generation is roomba, roomba500 or create, not \"r2d2\"");
  EXPECT_EQ(build(R"(driver( name "roomba" provides ["laser:0"] ))"),
            "test.cfg:1: driver \"roomba\" provides no such device as \"laser:0\"; it has position2d, power, "
            "bumper, ir, "
            "opaque, gripper");
}

}  // namespace
}  // namespace playhouse::drivers
