// The driver against a script that says what a unit said to the original driver, and against the emulator.

#include "playhouse/drivers/ptu46/ptu46.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "playhouse/drivers/hardware/testing_hardware.h"

namespace playhouse::drivers {
namespace {

namespace ptz = wire::ptz;
using testing::FarEnd;
using testing::from_hex;
using testing::HardwareTest;
using testing::to_hex;

constexpr const char* kUnit = R"(driver( name "ptu46" port "/dev/unit" provides ["ptz:1"] ))";
constexpr double kCount = 185.1428 / 3600 * 3.14159265358979 / 180;  // rad

std::string letters_of(const RawBytes& bytes) {
  std::string text;
  for (const std::byte byte : bytes) text.push_back(static_cast<char>(byte));
  return text;
}
Bytes look_at(float pan, float tilt, float pan_speed = 0, float tilt_speed = 0) {
  return server::message(wire::MessageType::kCmd, ptz::kCode, 1, ptz::kCmdState,
                         wire::encode(ptz::Cmd{pan, tilt, 0, pan_speed, tilt_speed}));
}
Bytes control(std::uint32_t mode) {
  return server::message(wire::MessageType::kReq, ptz::kCode, 1, ptz::kReqControlMode,
                         wire::encode(ptz::ReqControlMode{mode}));
}

class PtuScript : public HardwareTest {
 protected:
  void begin() {
    ASSERT_EQ(build(kUnit), "");
    client = client_of(ptz::kCode, 1);
    EXPECT_EQ(letters_of(unit.take(0.05)), " ");
    EXPECT_EQ(letters_of(unit.take(0.1)), "ft ed ci i ");
    say("ft *\r\ned *\r\n*\r\n*\r\n");
    unit.take(0.13);
  }
  void say(const std::string& text) { unit.send(std::as_bytes(std::span(text))); }
  /// Answers questions as the unit of the capture did, for so long; what else was said is kept and answered by "*".
  std::string said(double seconds = 0.3) {
    std::string others;
    for (double passed = 0; passed < seconds; passed += 0.01) {
      heard_ += letters_of(unit.take(0.01));
      for (std::size_t end = heard_.find(' ', 1); end != std::string::npos; end = heard_.find(' ', 1)) {
        const std::string command = heard_.substr(0, end);
        heard_.erase(0, end + 1);
        if (command == " r") {  // after which it knows all
          answers["pr"] = "185.1428";
          others += " r ";
          say("!T!T!P!P*\r\n");
        } else if (const auto answer = answers.find(command); answer != answers.end()) {
          say("* " + answer->second + "\r\n");
        } else {
          others += command + " ";
          say(reply + "\r\n");
        }
      }
    }
    return others;
  }

  FarEnd unit{network_, "/dev/unit"};
  std::unique_ptr<server::TestClient> client;
  std::string reply = "*";  // to what is no question
  std::map<std::string, std::string> answers = {
      {"tr", "185.1428"}, {"pr", "185.1428"}, {"pn", "-3090"}, {"px", "3090"}, {"tn", "-907"},
      {"tx", "604"},      {"pl", "0"},        {"pu", "2902"},  {"tl", "0"},    {"tu", "2902"},
      {"pp", "222"},      {"tp", "-111"},     {"ps", "1000"},  {"ts", "500"}};

 private:
  std::string heard_;
};

TEST_F(PtuScript, directions_are_counts_by_the_resolution) {
  begin();
  EXPECT_EQ(access, 1);
  EXPECT_EQ(said(0.6), "");
  const auto view = latest<ptz::Data>(*client, ptz::kCode, ptz::kDataState, 0);
  EXPECT_NEAR(view.pan, 0.1993, 0.0001) << "as the original's client read it";
  EXPECT_NEAR(view.tilt, -111 * kCount, 1e-6);
  EXPECT_EQ(view.panspeed, 0) << "which shapes moves alone";
}

TEST_F(PtuScript, commands_are_those_of_the_original) {
  begin();
  said(0.6);
  client->ask(look_at(0.2F, -0.1F));
  EXPECT_EQ(said(), "pp223 tp-111 ") << "222.8 counts, which the original cuts";
  client->ask(look_at(9, 0));
  EXPECT_EQ(said(), "pp3090 tp0 ") << "as far as it goes; the original stays";
  client->ask(control(ptz::kVelocityControl));
  EXPECT_EQ(said(), "cv ");
  client->ask(look_at(0, 0, 0.3F, 0.1F));
  EXPECT_EQ(said(), "ps334 ts111 ");
  EXPECT_NEAR(latest<ptz::Data>(*client, ptz::kCode, ptz::kDataState, 0).panspeed, 1000 * kCount, 1e-6);
  client->ask(look_at(0, 0, -9, 0));
  EXPECT_EQ(said(), "ps-2902 ts0 ");
  client->ask(control(ptz::kPositionControl));
  EXPECT_EQ(said(), "h ci ");
  client->ask(look_at(0, 0, 0.3F));
  EXPECT_EQ(said(), "ps334 pp0 tp0 ");
  client->ask(look_at(NAN, 0));
  EXPECT_EQ(said(), "");
}

TEST_F(PtuScript, what_turns_stands_when_the_last_client_has_gone) {
  begin();
  said(0.6);
  client->ask(control(ptz::kVelocityControl));
  client->ask(look_at(0, 0, 0.3F, 0));
  said();
  client->peer.reset();
  EXPECT_TRUE(letters_of(unit.take(0.05)).ends_with("h "));
}

/// In the original every later value is one poll behind: pan showed the tilt's speed.
TEST_F(PtuScript, limits_that_are_met_shift_nothing) {
  begin();
  said(0.6);
  say("!P\r\n");
  said();
  EXPECT_NEAR(latest<ptz::Data>(*client, ptz::kCode, ptz::kDataState, 0).pan, 222 * kCount, 1e-6);
}

TEST_F(PtuScript, a_unit_that_does_not_know_its_limits_is_reset_once) {
  answers.erase("pr");
  reply = "! Unknown command";
  begin();
  EXPECT_EQ(said(0.6), "pr  r ");
  EXPECT_NEAR(latest<ptz::Data>(*client, ptz::kCode, ptz::kDataState, 0).pan, 222 * kCount, 1e-6);
}

TEST_F(PtuScript, a_reply_that_is_lost_is_asked_for_again_and_a_silent_unit_retires) {
  begin();
  EXPECT_EQ(letters_of(unit.take(0.05)), "tr ");
  EXPECT_EQ(letters_of(unit.take(1)), "tr ");
  said(0.6);
  client->read();
  network_.run_for(4);
  EXPECT_EQ(server::outline(client->ask(server::open_request(ptz::kCode, 1))), "ACK 3, NACK 3");
}

class PtuPair : public HardwareTest {
 protected:
  server::FakeDriver& mount = add_device(ptz::kCode);

  void begin(const std::string& more = "", const std::string& of_emulator = "") {
    std::string section = kUnit;
    section.insert(section.size() - 1, more);
    mount.answers[ptz::kReqControlMode] = {};
    ASSERT_EQ(build(R"(driver( name "ptu46_emulator" port "/dev/unit" requires ["ptz:0"])" + of_emulator +
                    ")\n" + section),
              "");
    client = client_of(ptz::kCode, 1);
    network_.run_for(1);
  }
  ptz::Cmd wanted() const {
    return mount.commands.empty() ? ptz::Cmd{} : *wire::decode<ptz::Cmd>(mount.commands.back().second);
  }
  std::unique_ptr<server::TestClient> client;
};

TEST_F(PtuPair, what_is_commanded_arrives_and_what_is_seen_comes_back) {
  begin();
  client->ask(look_at(0.7F, -0.2F));
  network_.run_for(0.5);
  EXPECT_NEAR(wanted().pan, 0.7, kCount / 2);
  EXPECT_NEAR(wanted().tilt, -0.2, kCount / 2);
  publish(ptz::kCode, ptz::kDataState, ptz::Data{.pan = -0.31F, .tilt = 0.17F});
  const auto view = latest<ptz::Data>(*client, ptz::kCode, ptz::kDataState, 0.5);
  EXPECT_NEAR(view.pan, -0.31, kCount / 2);
  EXPECT_NEAR(view.tilt, 0.17, kCount / 2);
  client->ask(look_at(3, 3));
  network_.run_for(0.5);
  EXPECT_NEAR(wanted().pan, 158.9 * 3.14159265 / 180, kCount);
  EXPECT_NEAR(wanted().tilt, 31.06 * 3.14159265 / 180, kCount);
}

TEST_F(PtuPair, it_turns_at_speeds_and_stands_when_the_last_client_has_gone) {
  begin("", " resolution 46.2857");
  client->ask(control(ptz::kVelocityControl));
  client->ask(look_at(0, 0, 0.5F, -0.2F));
  network_.run_for(0.5);
  EXPECT_NEAR(wanted().panspeed, 0.5, kCount / 8);
  EXPECT_NEAR(wanted().tiltspeed, -0.2, kCount / 8);
  EXPECT_EQ(mount.requests, 1) << "the mount controls its speed now";
  client->peer.reset();
  network_.run_for(0.5);
  EXPECT_EQ(wanted().panspeed, 0);
}

TEST_F(PtuPair, a_line_that_was_pulled_is_waited_for_and_noise_loses_no_command_for_long) {
  begin(" reconnect 1");
  network_.serial().unplug("/dev/unit");
  network_.run_for(2);
  network_.serial().plug("/dev/unit");
  network_.run_for(4);
  network_.serial().faults = {.loss = 0.002, .change = 0.002};
  for (int turn = 0; turn < 20; ++turn) {
    client->ask(look_at(0.02F * static_cast<float>(turn), 0));
    network_.run_for(0.5);
  }
  network_.serial().faults = {};
  network_.run_for(6);
  client->ask(look_at(0.25F, 0));
  network_.run_for(2);
  EXPECT_NEAR(wanted().pan, 0.25, kCount);
}

TEST_F(PtuPair, at_another_speed_nothing_answers) {
  begin("", " baud 19200");
  network_.run_for(5);
  EXPECT_EQ(server::outline(client->ask(server::open_request(ptz::kCode, 1))), "ACK 3, NACK 3");
}

/// As other drivers than ours speak to it.
class PtuHost : public HardwareTest {
 protected:
  server::FakeDriver& mount = add_device(ptz::kCode);
  struct HostEnd : net::SerialEvents {
    explicit HostEnd(net::SimulatedNetwork& network) : line(*network.open_serial("/dev/unit", {})) {
      line->start(*this);
    }
    void received(std::span<const std::byte> news) override {
      bytes.insert(bytes.end(), news.begin(), news.end());
    }
    void ended(const std::string&) override {}
    std::unique_ptr<net::SerialLine> line;
    RawBytes bytes;
  };
  PtuHost() {
    EXPECT_EQ(build(R"(driver( name "ptu46_emulator" port "/dev/unit" requires ["ptz:0"] ))"), "");
    host = std::make_unique<HostEnd>(network_);
  }
  std::string ask(std::string_view text, double seconds = 0.15) {
    host->line->send(std::as_bytes(std::span(text)));
    network_.run_for(seconds);
    return letters_of(std::exchange(host->bytes, {}));
  }
  std::string ask_binary(std::string_view hex, double seconds = 0.05) {
    host->line->send(from_hex(hex));
    network_.run_for(seconds);
    return to_hex(std::exchange(host->bytes, {}));
  }
  std::unique_ptr<HostEnd> host;
};

TEST_F(PtuHost, it_echoes_and_speaks_in_words_until_it_is_told_not_to) {
  EXPECT_EQ(ask("PP "), "PP * Current Pan position is 0\r\n");
  EXPECT_EQ(ask("ft "), "ft *\r\n");
  EXPECT_EQ(ask("ed pp pr px tn "), "ed *\r\n* 0\r\n* 185.1428\r\n* 3090\r\n* -907\r\n");
  EXPECT_EQ(ask("pp3091 "), "! Maximum allowable Pan position is 3090\r\n");
  EXPECT_EQ(ask("tp-908 "), "! Minimum allowable Tilt position is -907\r\n");
  EXPECT_EQ(ask("zz pp1x "), "! Illegal command\r\n! Illegal command\r\n");
  EXPECT_EQ(ask("ps0 "), "! Pan speed cannot be less than 57\r\n");
  EXPECT_EQ(ask("ps2903 cv ps0 ps-2902 ps "), "! Pan speed cannot exceed 2902\r\n*\r\n*\r\n*\r\n* -2902\r\n");
}

TEST_F(PtuHost, what_waits_is_answered_when_the_axes_are_there) {
  ask("ft ed ");
  EXPECT_EQ(ask("pp1000 po a tp "), "*\r\n* 1000\r\n") << "on its way";
  publish(ptz::kCode, ptz::kDataState, ptz::Data{.pan = static_cast<float>(1000 * kCount)});
  EXPECT_EQ(ask(""), "*\r\n* 0\r\n");
  EXPECT_EQ(ask("s pp500 "), "*\r\n*\r\n");
  const auto commands = mount.commands.size();
  ask("tp100 ");
  EXPECT_EQ(mount.commands.size(), commands) << "slaved";
  ask("a ");
  EXPECT_NEAR(wire::decode<ptz::Cmd>(mount.commands.back().second)->pan, 500 * kCount, 1e-6);
  publish(ptz::kCode, ptz::kDataState, ptz::Data{});
  EXPECT_EQ(ask("", 1), "*\r\n") << "what stands still is waited for no longer";
  EXPECT_EQ(ask("r ", 0.3), "!T!T!P!P*\r\n");
}

TEST_F(PtuHost, binary_commands_are_answered_as_the_maker_says) {
  EXPECT_EQ(ask_binary("81 03 e8"), "00");
  EXPECT_NEAR(wire::decode<ptz::Cmd>(mount.commands.back().second)->pan, 1000 * kCount, 1e-6);
  publish(ptz::kCode, ptz::kDataState, ptz::Data{.pan = static_cast<float>(1000 * kCount)});
  EXPECT_EQ(ask_binary("91"), "03 e8");
  EXPECT_EQ(ask_binary("96 98"), "fc 75 02 5c") << "tilt from -907 to 604";
  EXPECT_EQ(ask_binary("a5"), "00 00 2b 65") << "60 times 185.1428 are 11109";
  EXPECT_EQ(ask_binary("82 7f ff"), "03");
  EXPECT_EQ(ask_binary("cb cd cb"), "01 00 02");
  EXPECT_EQ(ask_binary("87 f0 00"), "04") << "-4096 is too fast";
  EXPECT_EQ(ask_binary("87 fc 18 9b"), "00 fc 18");
  EXPECT_EQ(ask_binary("8f"), "02") << "no command";
}

TEST_F(PtuHost, sections_with_faults_say_what_is_valid) {
  EXPECT_EQ(
      build(R"(driver( name "ptu46_emulator" port "/dev/unit" requires ["ptz:0"] pan_limits [30 -30] ))"),
      "test.cfg:1: pan_limits is two angles, the smaller one first");
  EXPECT_EQ(build(R"(driver( name "ptu46" provides ["laser:1"] ))"),
            "test.cfg:1: driver \"ptu46\" provides no such device as \"laser:1\"; it has ptz");
}

}  // namespace
}  // namespace playhouse::drivers
