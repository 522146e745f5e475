// The driver against a script that says what a camera said to the original driver, and against the emulator.

#include "playhouse/drivers/sonyevid30/sonyevid30.h"

#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/drivers/hardware/testing_hardware.h"

namespace playhouse::drivers {
namespace {

namespace ptz = wire::ptz;
using testing::FarEnd;
using testing::from_hex;
using testing::HardwareTest;
using testing::to_hex;

constexpr const char* kCameraSection = R"(driver( name "sonyevid30" port "/dev/eye" provides ["ptz:1"] ))";

Bytes look(float pan, float tilt, float zoom = 0, float pan_speed = 0, float tilt_speed = 0) {
  return server::message(wire::MessageType::kCmd, ptz::kCode, 1, ptz::kCmdState,
                         wire::encode(ptz::Cmd{pan, tilt, zoom, pan_speed, tilt_speed}));
}

class SonyScript : public HardwareTest {
 protected:
  void begin(const std::string& version = "90 50 00 01 04 02 00 01 02 ff",
             const std::string& power = "90 50 02 ff") {
    ASSERT_EQ(build(kCameraSection), "");
    client = client_of(ptz::kCode, 1);
    EXPECT_EQ(camera_says(version), "81 09 00 02 ff");
    EXPECT_EQ(camera_says(power), "81 09 04 00 ff");
  }
  /// Answers the frame that is out, and tells which it was.
  std::string camera_says(const std::string& reply, double seconds = 0.02) {
    const std::string asked = to_hex(camera.take(seconds));
    camera.send(from_hex(reply));
    return asked;
  }
  /// Answers questions until a command comes; "" if none does.
  std::string next_command() {
    for (int round = 0; round < 20; ++round) {
      const std::string sent = to_hex(camera.take(0.03));
      if (sent == "81 09 06 12 ff") {
        camera.send(from_hex("90 50 " + direction + " ff"));
      } else if (sent == "81 09 04 47 ff") {
        camera.send(from_hex("90 50 00 01 04 05 ff"));
      } else if (!sent.empty()) {
        return sent;
      }
    }
    return "";
  }
  void ack(int socket) { camera.send(from_hex(socket == 1 ? "90 41 ff" : "90 42 ff")); }

  FarEnd camera{network_, "/dev/eye"};
  std::unique_ptr<server::TestClient> client;
  std::string direction = "0f 0e 0f 08 0f 0f 09 04";
};

TEST_F(SonyScript, directions_and_views_are_those_of_the_camera) {
  begin();
  EXPECT_EQ(access, 1);
  EXPECT_EQ(next_command(), "");
  const auto view = latest<ptz::Data>(*client, ptz::kCode, ptz::kDataState, 0);
  EXPECT_NEAR(view.pan, 30 * 3.14159265 / 180, 1e-5) << "not 29 degrees, as with the original";
  EXPECT_NEAR(view.tilt, -9 * 3.14159265 / 180, 1e-5);
  EXPECT_NEAR(view.zoom, (48.8 - 44.4 * 0x145 / 1023.0) * 3.14159265 / 180, 1e-5);
}

TEST_F(SonyScript, commands_are_those_of_the_original) {
  begin();
  client->ask(look(0.5236F, -0.15708F, 0.3F));
  EXPECT_EQ(next_command(), "81 01 06 02 18 14 0f 0e 0f 08 0f 0f 09 04 ff");
  ack(1);
  EXPECT_EQ(next_command(), "81 01 04 47 00 02 0d 08 ff")
      << "728 of 1023 for 17.2 between 48.8 and 4.4 degrees";
  ack(2);
  camera.send(from_hex("90 51 ff 90 52 ff"));
  EXPECT_EQ(next_command(), "");
  client->ask(request(ptz::kCode, ptz::kReqControlMode, ptz::ReqControlMode{ptz::kVelocityControl}, 1));
  client->ask(look(0, 0, 0, 0.3F, 0.1F));
  EXPECT_EQ(next_command(), "81 01 06 01 05 02 01 01 ff");
  ack(1);
  client->peer.reset();
  EXPECT_EQ(next_command(), "81 01 06 01 01 01 03 03 ff") << "it stands when the last client has gone";
}

TEST_F(SonyScript, a_camera_that_is_off_is_switched_on) {
  begin("90 50 00 01 04 0d 00 01 02 ff", "90 50 03 ff");
  EXPECT_EQ(camera_says("90 41 ff"), "81 01 04 00 02 ff");
  client->ask(look(0.5236F, 0));
  EXPECT_EQ(next_command(), "81 01 06 02 18 14 0f 0e 05 00 00 00 00 00 ff")
      << "a D100: 14.4 units in a degree";
}

/// As with the original, whose camera then answered 04 for each.
TEST_F(SonyScript, sockets_that_are_both_taken_are_cancelled) {
  begin();
  client->ask(look(0.1F, 0));
  next_command();
  ack(1);
  client->ask(look(0.2F, 0));
  next_command();
  ack(2);
  client->ask(look(0.3F, 0));
  EXPECT_EQ(next_command(), "81 21 ff");
  camera.send(from_hex("90 61 04 ff"));
  EXPECT_EQ(next_command(), "81 22 ff");
  camera.send(from_hex("90 62 05 ff"));
  EXPECT_EQ(next_command().substr(0, 17), "81 01 06 02 18 14");
}

TEST_F(SonyScript, an_answer_that_is_lost_is_asked_for_again) {
  ASSERT_EQ(build(kCameraSection), "");
  client = client_of(ptz::kCode, 1);
  EXPECT_EQ(to_hex(camera.take(0.1)), "81 09 00 02 ff");
  camera.send(from_hex("90 50 00 01 04"));
  EXPECT_EQ(camera_says("ff 90 50 00 01 04 02 00 01 02 ff", 0.6), "81 09 00 02 ff");
  EXPECT_EQ(to_hex(camera.take(0.05)), "81 09 04 00 ff");
}

TEST_F(SonyScript, a_silent_camera_retires_with_its_device) {
  ASSERT_EQ(build(kCameraSection), "");
  client = client_of(ptz::kCode, 1);
  client->read();
  network_.run_for(4);
  EXPECT_EQ(server::outline(client->ask(server::open_request(ptz::kCode, 1))), "ACK 3, NACK 3");
}

TEST_F(SonyScript, no_number_is_no_command) {
  begin();
  client->ask(look(NAN, 0));
  EXPECT_EQ(next_command(), "");
}

class SonyPair : public HardwareTest {
 protected:
  server::FakeDriver& mount = add_device(ptz::kCode);

  void begin(const std::string& more = "", const std::string& of_emulator = "") {
    std::string section = kCameraSection;
    section.insert(section.size() - 1, more);
    mount.answers[ptz::kReqControlMode] = {};
    ASSERT_EQ(build(R"(driver( name "sonyevid30_emulator" port "/dev/eye" requires ["ptz:0"])" + of_emulator +
                    ")\n" + section),
              "");
    client = client_of(ptz::kCode, 1);
    network_.run_for(0.5);
  }
  ptz::Cmd wanted() const {
    return mount.commands.empty() ? ptz::Cmd{} : *wire::decode<ptz::Cmd>(mount.commands.back().second);
  }
  ptz::Data heard(const ptz::Data& told) {
    publish(ptz::kCode, ptz::kDataState, told);
    return latest<ptz::Data>(*client, ptz::kCode, ptz::kDataState, 0.5);
  }
  std::unique_ptr<server::TestClient> client;
};

TEST_F(SonyPair, what_is_commanded_arrives_and_what_is_seen_comes_back) {
  begin();
  client->ask(look(0.7F, -0.2F, 0.4F));
  network_.run_for(0.5);
  constexpr double kHalfPan = 3.15 / 180 / 8.8 / 2, kHalfTilt = 3.15 / 180 / 12 / 2;  // of a unit
  EXPECT_NEAR(wanted().pan, 0.7, kHalfPan);
  EXPECT_NEAR(wanted().tilt, -0.2, kHalfTilt);
  EXPECT_NEAR(wanted().zoom, 0.4, 0.0004);
  const auto view = heard({.pan = 0.31F, .tilt = 0.17F, .zoom = 0.5F});
  EXPECT_NEAR(view.pan, 0.31, kHalfPan);
  EXPECT_NEAR(view.tilt, 0.17, kHalfTilt);
  EXPECT_NEAR(view.zoom, 0.5, 0.0004);
}

TEST_F(SonyPair, cameras_of_another_model_have_other_units) {
  begin("", R"( camera "d100" on 0)");
  client->ask(look(1.5F, 0.3F, 0.2F));
  network_.run_for(0.5);
  EXPECT_NEAR(wanted().pan, 1.5, 0.0013) << "it was off, and 14.4 units are a degree";
  EXPECT_NEAR(wanted().tilt, 0.3, 0.0013);
  EXPECT_NEAR(wanted().zoom, 0.2, 0.0001);
}

TEST_F(SonyPair, it_turns_at_speeds) {
  begin();
  client->ask(request(ptz::kCode, ptz::kReqControlMode, ptz::ReqControlMode{ptz::kVelocityControl}, 1));
  client->ask(look(0, 0, 0, 0.5F, -0.2F));
  network_.run_for(0.5);
  EXPECT_NEAR(wanted().panspeed, 0.5, 0.03) << "3.3 deg/s are a code";
  EXPECT_NEAR(wanted().tiltspeed, -0.2, 0.022);
  EXPECT_EQ(mount.requests, 1) << "the mount controls its speed now";
  client->peer.reset();
  network_.run_for(0.5);
  EXPECT_EQ(wanted().panspeed, 0);
}

TEST_F(SonyPair, every_one_of_many_commands_ends_and_the_last_one_holds) {
  begin();
  for (int turn = 0; turn < 30; ++turn) {
    client->ask(look(0.02F * static_cast<float>(turn), 0, 0.5F + 0.01F * static_cast<float>(turn % 3)));
    network_.run_for(0.05);
  }
  network_.run_for(2);
  EXPECT_NEAR(wanted().pan, 0.58, 0.002);
  client->ask(look(-0.3F, 0));
  network_.run_for(0.5);
  EXPECT_NEAR(wanted().pan, -0.3, 0.002);
}

TEST_F(SonyPair, a_noisy_line_loses_no_command_for_long) {
  begin();
  network_.serial().faults = {.loss = 0.005, .change = 0.005};
  for (int turn = 0; turn < 20; ++turn) {
    client->ask(look(0.02F * static_cast<float>(turn), 0));
    network_.run_for(0.5);
  }
  network_.serial().faults = {};
  client->ask(look(0.25F, 0));
  network_.run_for(2);
  EXPECT_NEAR(wanted().pan, 0.25, 0.002);
}

TEST_F(SonyPair, a_line_that_was_pulled_is_waited_for) {
  begin(" reconnect 1");
  network_.serial().unplug("/dev/eye");
  network_.run_for(2);
  network_.serial().plug("/dev/eye");
  network_.run_for(4);
  client->ask(look(0.2F, 0));
  network_.run_for(0.5);
  EXPECT_NEAR(wanted().pan, 0.2, 0.002);
}

TEST_F(SonyPair, at_another_speed_nothing_answers) {
  begin("", " baud 38400");
  network_.run_for(5);
  EXPECT_EQ(server::outline(client->ask(server::open_request(ptz::kCode, 1))), "ACK 3, NACK 3");
}

/// As other drivers than ours speak to it.
class SonyHost : public HardwareTest {
 protected:
  server::FakeDriver& mount = add_device(ptz::kCode);
  struct HostEnd : net::SerialEvents {
    explicit HostEnd(net::SimulatedNetwork& network) : line(*network.open_serial("/dev/eye", {})) {
      line->start(*this);
    }
    void received(std::span<const std::byte> news) override {
      bytes.insert(bytes.end(), news.begin(), news.end());
    }
    void ended(const std::string&) override {}
    std::unique_ptr<net::SerialLine> line;
    RawBytes bytes;
  };
  SonyHost() {
    EXPECT_EQ(build(R"(driver( name "sonyevid30_emulator" port "/dev/eye" requires ["ptz:0"] ))"), "");
    host = std::make_unique<HostEnd>(network_);
  }
  std::string ask(const std::string& hex, double seconds = 0.04) {
    host->line->send(from_hex(hex));
    network_.run_for(seconds);
    return to_hex(std::exchange(host->bytes, {}));
  }
  std::unique_ptr<HostEnd> host;
};

TEST_F(SonyHost, questions_are_answered_as_the_maker_says) {
  EXPECT_EQ(ask("88 30 01 ff"), "88 30 02 ff");
  EXPECT_EQ(ask("88 01 00 01 ff"), "88 01 00 01 ff");
  EXPECT_EQ(ask("81 01 00 01 ff"), "90 50 ff");
  EXPECT_EQ(ask("81 09 00 02 ff"), "90 50 00 01 04 02 00 01 02 ff");
  EXPECT_EQ(ask("81 09 06 11 ff"), "90 50 18 14 ff");
  EXPECT_EQ(ask("81 09 06 77 ff"), "90 60 02 ff");
  EXPECT_EQ(ask("82 09 00 02 ff"), "") << "another camera's";
  publish(ptz::kCode, ptz::kDataState, ptz::Data{.pan = 0.5236F, .tilt = -0.15708F});
  EXPECT_EQ(ask("81 09 06 12 ff"), "90 50 0f 0e 0f 08 0f 0f 09 04 ff");
}

TEST_F(SonyHost, half_a_command_is_forgotten_after_a_pause) {
  EXPECT_EQ(ask("81 01 06 02", 1), "");
  EXPECT_EQ(ask("81 01 00 01 ff"), "90 50 ff");
}

TEST_F(SonyHost, a_move_is_completed_when_it_is_there) {
  EXPECT_EQ(ask("81 01 06 02 18 14 0f 0e 0f 08 00 00 00 00 ff"), "90 41 ff");
  publish(ptz::kCode, ptz::kDataState, ptz::Data{.pan = 0.2F});
  network_.run_for(0.1);
  EXPECT_TRUE(host->bytes.empty()) << "on its way";
  publish(ptz::kCode, ptz::kDataState, ptz::Data{.pan = 0.5236F});
  EXPECT_EQ(ask("", 0.1), "90 51 ff");
}

TEST_F(SonyHost, two_commands_run_at_a_time_and_can_be_cancelled) {
  publish(ptz::kCode, ptz::kDataState, ptz::Data{.zoom = 0.8F});
  EXPECT_EQ(ask("81 01 06 02 18 14 0f 0e 0f 08 00 00 00 00 ff"), "90 41 ff");
  EXPECT_EQ(ask("81 01 04 47 00 02 00 00 ff"), "90 42 ff");
  EXPECT_EQ(ask("81 01 06 02 18 14 00 00 00 00 00 00 00 00 ff"), "90 60 03 ff");
  EXPECT_EQ(ask("81 21 ff"), "90 61 04 ff");
  EXPECT_EQ(ask("81 21 ff"), "90 61 05 ff");
  EXPECT_EQ(ask("81 01 04 00 03 ff"), "90 41 ff 90 51 ff") << "off";
  EXPECT_EQ(ask("81 09 04 00 ff"), "90 50 03 ff");
  EXPECT_EQ(ask("81 22 ff"), "90 62 04 ff");
  EXPECT_EQ(ask("81 01 06 04 ff"), "90 60 41 ff");
}

TEST_F(SonyHost, limits_and_relative_moves_hold) {
  const auto pan = [this] { return wire::decode<ptz::Cmd>(mount.commands.back().second)->pan; };
  ask("81 01 06 07 00 01 00 00 0b 00 00 00 06 04 ff");  // to the right no further than 176 units, 20 degrees
  ask("81 01 06 02 18 14 00 03 07 00 00 00 00 00 ff", 1);
  EXPECT_NEAR(pan(), -20 * 3.14159265 / 180, 1e-5);
  ask("81 01 06 07 01 01 07 0f 0f 0f 07 0f 0f 0f ff");
  publish(ptz::kCode, ptz::kDataState, ptz::Data{.pan = -0.34906585F});
  ask("81 01 06 03 18 14 00 00 0b 00 00 00 00 00 ff", 1);
  EXPECT_NEAR(pan(), -40 * 3.14159265 / 180, 1e-5);
}

TEST_F(SonyHost, sections_with_faults_say_what_is_valid) {
  EXPECT_EQ(build(R"(driver( name "sonyevid30_emulator" port "/dev/eye" requires ["ptz:0"] camera "d50" ))"),
            "test.cfg:1: camera is d30, d70 or d100, not \"d50\"");
  EXPECT_EQ(build(R"(driver( name "sonyevid30" provides ["ptz:1"] fov [30 3] ))"),
            "test.cfg:1: fov is two angles, the smaller one first");
  EXPECT_EQ(build(R"(driver( name "sonyevid30" provides ["ptz:1"] baud 19200 ))"),
            "test.cfg:1: baud is 9600 or 38400");
}

}  // namespace
}  // namespace playhouse::drivers
