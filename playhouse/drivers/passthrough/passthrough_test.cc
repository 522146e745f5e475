// A relay between two servers over the simulated network: its clients are those of the one, its devices those
// of the other.

#include "playhouse/drivers/passthrough/passthrough.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <set>

#include "playhouse/drivers/testing/memory_site.h"
#include "playhouse/net/simulated.h"
#include "playhouse/server/fake_driver.h"
#include "playhouse/server/server.h"
#include "playhouse/server/test_client.h"
#include "playhouse/wire/generated/aio.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {
namespace {

namespace lsr = wire::laser;
namespace p2d = wire::position2d;
using server::FakeDriver;
using server::message;
using server::Received;
using server::TestClient;
using wire::MessageType;

constexpr std::uint16_t kHere = 6665, kThere = 7000;
constexpr const char* kWheels =
    "driver( name \"passthrough\" provides [\"position2d:0\"] requires [\"lab:7000:position2d:5\"] )";
constexpr const char* kKept =
    "driver( name \"passthrough\" provides [\"position2d:0\"] requires [\"lab:7000:position2d:5\"] reconnect "
    "1 )";

class Relay : public ::testing::Test, public Host {
 protected:
  Relay() {
    site.data_flow().pass_to(here);
    EXPECT_TRUE(here.listen(kHere));
  }
  /// The other server, with position2d:5.
  void open_lab() {
    lab = std::make_unique<server::Server>(network_);
    EXPECT_TRUE(lab->listen(kThere));
    wheels_id = *lab->add_device({kThere, p2d::kCode, 5}, wheels);
  }
  /// "", or the error's line.
  std::string build(const std::string& cfg) {
    const std::string error = testing::build_drivers(cfg, site, drivers);
    if (error.empty()) network_.run();
    return error;
  }
  static Bytes ask(std::uint8_t subtype, const Bytes& body = {}) {
    return message(MessageType::kReq, p2d::kCode, 0, subtype, body, 7);
  }
  static Bytes drive(double speed) {
    return message(MessageType::kCmd, p2d::kCode, 0, p2d::kCmdVel,
                   wire::encode(p2d::CmdVel{{speed, 0, 0}, 1}));
  }
  static Bytes close_request() { return server::open_request(p2d::kCode, 0, 2); }
  static Bytes push() { return server::mode_request(1); }
  static bool is_open(const std::vector<Received>& answers) { return server::access_of(answers.at(0)) == 1; }

  Result<device::DeviceId> add_device(device::Address address, device::Driver& driver) override {
    return here.add_device(address, driver);
  }
  void retire_device(device::DeviceId device) override { here.retire_device(device); }
  Result<void> hold(device::DeviceId device, device::Driver* holder) override {
    return here.hold(device, holder);
  }
  void release(device::DeviceId device, device::Driver* holder) override { here.release(device, holder); }
  void post(std::function<void()> task) override { network_.post(std::move(task)); }
  net::Network& network() override { return network_; }
  Result<std::unique_ptr<run::Simulation>> open_world(const std::string&) override {
    return Error{"", "none"};
  }

  net::SimulatedNetwork network_{13};
  FakeDriver wheels{"wheels"}, laser{"laser"};
  std::unique_ptr<server::Server> lab;
  device::DeviceId wheels_id;
  Site site{*this, kHere};
  std::vector<std::unique_ptr<device::Driver>> drivers;
  server::Server here{network_};
};

TEST_F(Relay, what_clients_say_and_are_told_passes_byte_for_byte) {
  open_lab();
  wheels.answers[p2d::kReqGetGeom] = wire::encode(p2d::Geom{{1, 2, 3, 4, 5, 6}, {7, 8, 9}});
  ASSERT_EQ(build(kWheels), "");
  TestClient client(network_, kHere);
  client.ask(push());
  ASSERT_TRUE(is_open(client.ask(server::open_request(p2d::kCode, 0))));

  const std::vector<Received> geometry = client.ask(ask(p2d::kReqGetGeom));
  ASSERT_EQ(server::outline(geometry), "ACK " + std::to_string(p2d::kReqGetGeom));
  EXPECT_EQ(geometry[0].body, wheels.answers[p2d::kReqGetGeom]);
  EXPECT_EQ(geometry[0].header.seq, 7u);

  client.ask(drive(0.25));
  ASSERT_EQ(wheels.commands.size(), 1u);
  EXPECT_EQ(wheels.commands[0].second, wire::encode(p2d::CmdVel{{0.25, 0, 0}, 1}));

  const Bytes state = wire::encode(p2d::Data{{1, 2, 3}, {4, 5, 6}, 1});
  lab->publish({{wheels_id, p2d::kDataState, 12.5, state}});
  const std::vector<Received> data = client.read();
  ASSERT_EQ(server::outline(data), "DATA 1 of 4");
  EXPECT_EQ(data[0].body, state);
  EXPECT_EQ(data[0].header.index, 0u);
  EXPECT_EQ(data[0].header.timestamp, 12.5);
}

TEST_F(Relay, a_refusal_has_its_body) {
  open_lab();
  wheels.bounces = true;
  ASSERT_EQ(build(kWheels), "");
  TestClient client(network_, kHere);
  const Bytes body = wire::encode(p2d::PowerConfig{1});
  const std::vector<Received> answer = client.ask(ask(p2d::kReqMotorPower, body));
  ASSERT_EQ(server::outline(answer), "NACK " + std::to_string(p2d::kReqMotorPower));
  EXPECT_EQ(answer[0].body, body);
}

TEST_F(Relay, capabilities_are_those_of_the_device_there) {
  open_lab();
  ASSERT_EQ(build(kWheels), "");
  TestClient client(network_, kHere);
  const Bytes asked = wire::encode(wire::CapabilitiesReq{3, p2d::kReqGetGeom});
  EXPECT_EQ(client.ask(ask(wire::kReqCapabilities, asked)).at(0).header.type, MessageType::kNack);
  wheels.capable_of_all = true;
  EXPECT_EQ(client.ask(ask(wire::kReqCapabilities, asked)).at(0).header.type, MessageType::kAck);
}

TEST_F(Relay, a_device_is_open_there_while_somebody_has_it_open_here) {
  open_lab();
  ASSERT_EQ(build(kWheels), "");
  EXPECT_EQ(wheels.starts, 0);
  TestClient first(network_, kHere), second(network_, kHere);
  first.ask(server::open_request(p2d::kCode, 0));
  second.ask(server::open_request(p2d::kCode, 0));
  EXPECT_EQ(wheels.starts, 1);
  first.ask(close_request());
  EXPECT_EQ(wheels.stops, 0);
  second.peer.finish();
  network_.run();
  EXPECT_EQ(wheels.stops, 1);
  EXPECT_EQ(wheels.starts, 1);
}

TEST_F(Relay, drivers_use_devices_of_a_port_that_this_file_does_not_serve) {
  open_lab();
  ASSERT_TRUE(lab->add_device({kThere, lsr::kCode, 0}, laser));
  ASSERT_EQ(build("driver( name \"vfh\" provides [\"position2d:1\"] requires [\"7000:position2d:5\" "
                  "\"7000:laser:0\"] )"),
            "");
  EXPECT_EQ(site.ports(), (std::set<std::uint32_t>{kHere})) << "none to listen on";
  TestClient client(network_, kHere);
  ASSERT_TRUE(is_open(client.ask(server::open_request(p2d::kCode, 1))));
  EXPECT_EQ(wheels.starts, 1);
  EXPECT_EQ(laser.starts, 1);
  client.ask(
      message(MessageType::kCmd, p2d::kCode, 1, p2d::kCmdVel, wire::encode(p2d::CmdVel{{0.5, 0, 0}, 1}), 7));
  ASSERT_EQ(wheels.commands.size(), 1u);
  EXPECT_EQ(wheels.commands[0].second, wire::encode(p2d::CmdVel{{0.5, 0, 0}, 1}));
}

TEST_F(Relay, a_device_that_retires_there_retires_here) {
  open_lab();
  ASSERT_EQ(build(kWheels), "");
  TestClient client(network_, kHere);
  client.ask(push());
  client.ask(server::open_request(p2d::kCode, 0));
  lab->retire_device(wheels_id);
  const std::vector<Received> told = client.read();
  ASSERT_EQ(server::outline(told), "ACK 3");
  EXPECT_EQ(server::access_of(told[0]), 'e');
  EXPECT_EQ(site.device_count(), 0u);
}

TEST_F(Relay, devices_retire_with_their_server) {
  open_lab();
  wheels.holds_requests = true;
  ASSERT_EQ(build(kWheels), "");
  TestClient client(network_, kHere);
  client.ask(push());
  client.ask(server::open_request(p2d::kCode, 0));
  client.ask(ask(p2d::kReqGetGeom));
  wheels.held.clear();
  network_.run();
  wheels.holds_requests = true;
  client.read();
  client.ask(ask(p2d::kReqGetGeom));  // is never answered
  std::vector<device::Replier> unanswered = std::exchange(wheels.held, {});
  ASSERT_EQ(unanswered.size(), 1u);
  unanswered.clear();
  lab.reset();
  EXPECT_EQ(client.read().back().header.subtype, wire::player::kReqDev);
  EXPECT_EQ(site.device_count(), 0u);
}

TEST_F(Relay, a_server_that_starts_later_is_found) {
  ASSERT_EQ(build(kWheels), "");
  network_.run_for(100);
  EXPECT_EQ(site.device_count(), 1u);
  TestClient client(network_, kHere);
  EXPECT_EQ(server::access_of(client.ask(server::open_request(p2d::kCode, 0)).at(0)), 3) << "nobody is there";
  open_lab();
  // Whoever opens the device shortens the wait, of half a minute by now.
  EXPECT_EQ(server::access_of(client.ask(server::open_request(p2d::kCode, 0)).at(0)), 3);
  network_.run_for(0.1);
  ASSERT_TRUE(is_open(client.ask(server::open_request(p2d::kCode, 0))));
  EXPECT_EQ(wheels.starts, 1);
  lab.reset();
  network_.run();
  EXPECT_EQ(site.device_count(), 0u) << "once it was there";
}

TEST_F(Relay, a_token_opens_the_other_server) {
  open_lab();
  lab->admit_by([](const std::string& token, const std::string&) {
    return token == "a-driver-" ? std::optional<device::Rights>(device::Rights()) : std::nullopt;
  });
  ASSERT_EQ(build("driver( name \"passthrough\" provides [\"position2d:0\"] "
                  "requires [\"lab:7000:position2d:5\"] token \"a-driver-\" )"),
            "");
  TestClient client(network_, kHere);
  client.ask(server::open_request(p2d::kCode, 0));
  EXPECT_EQ(wheels.starts, 1);
}

TEST_F(Relay, or_stay_and_are_opened_again_where_the_file_says_reconnect) {
  ASSERT_EQ(build(kKept), "");
  TestClient client(network_, kHere);
  client.ask(push());
  EXPECT_EQ(server::access_of(client.ask(server::open_request(p2d::kCode, 0)).at(0)), 3) << "nobody is there";
  open_lab();
  network_.run_for(1);
  ASSERT_TRUE(is_open(client.ask(server::open_request(p2d::kCode, 0))));
  EXPECT_EQ(wheels.starts, 1);
  lab.reset();
  network_.run();
  EXPECT_EQ(site.device_count(), 1u);
  EXPECT_EQ(client.ask(ask(p2d::kReqGetGeom)).at(0).header.type, MessageType::kNack);
  network_.run_for(20);
  open_lab();
  network_.run_for(40);
  EXPECT_EQ(wheels.starts, 2);
  wheels.answers[p2d::kReqGetGeom] = wire::encode(p2d::Geom{});
  EXPECT_EQ(client.ask(ask(p2d::kReqGetGeom)).at(0).header.type, MessageType::kAck);
}

/// Each asked the other for ever, and so did every command.
TEST_F(Relay, two_that_stand_for_each_other_retire) {
  ASSERT_EQ(build("driver( name \"passthrough\" provides [\"position2d:0\" \"laser:0\"] "
                  "requires [\"here:6665:position2d:1\" \"here:6665:laser:3\"] )\n"
                  "driver( name \"passthrough\" provides [\"position2d:1\" \"laser:1\"] "
                  "requires [\"here:6665:position2d:0\" \"here:6665:laser:3\"] )"),
            "");
  EXPECT_EQ(site.device_count(), 2u) << "the lasers: both lead to one that is absent";
  TestClient client(network_, kHere);
  EXPECT_FALSE(is_open(client.ask(server::open_request(p2d::kCode, 0))));
  EXPECT_EQ(client.ask(ask(p2d::kReqGetGeom)).at(0).header.type, MessageType::kNack);
}

TEST_F(Relay, a_way_through_two_devices_of_one_section_is_no_circle) {
  open_lab();
  ASSERT_EQ(build("driver( name \"passthrough\" provides [\"position2d:0\" \"position2d:1\"] "
                  "requires [\"here:6665:position2d:1\" \"here:6665:position2d:2\"] )\n"
                  "driver( name \"passthrough\" provides [\"position2d:2\"] "
                  "requires [\"lab:7000:position2d:5\"] )"),
            "");
  EXPECT_EQ(site.device_count(), 3u);
  TestClient client(network_, kHere);
  client.ask(server::open_request(p2d::kCode, 0));
  EXPECT_EQ(wheels.starts, 1);
}

/// Somebody who listens at the other port, and what the relay says to it.
class Script final : public net::ConnectionEvents {
 public:
  explicit Script(net::SimulatedNetwork& network)
      : listener(*network.listen("", kThere, [this](std::unique_ptr<net::Connection> connection) {
          one = std::move(connection);
          one->start(*this);
        })) {}
  void say(std::string_view text) {
    const auto raw = std::as_bytes(std::span(text));
    say(Bytes(raw.begin(), raw.end()));
  }
  void say(Bytes bytes) {
    const net::SharedBytes shared = std::make_shared<const Bytes>(std::move(bytes));
    one->send(std::span(&shared, 1));
  }
  void greet() { say(std::string("Player v.3.1.0").append(18, '\0')); }
  void received(std::span<const std::byte> bytes) override {
    heard.insert(heard.end(), bytes.begin(), bytes.end());
  }
  void drained() override {}
  void lost() override {}
  void closed(const std::string&) override { ended = true; }

  std::unique_ptr<net::Connection> one;
  Bytes heard;
  bool ended = false;
  std::unique_ptr<net::Listener> listener;
};

TEST_F(Relay, who_is_no_player_server_is_left) {
  for (const std::string_view text : {"HTTP/1.1 400 Bad Request\r\n", "Player w.3", "P\0"}) {
    Script script(network_);
    ASSERT_EQ(build(kWheels), "");
    script.say(text);
    network_.run_for(11);  // for the last one, which says too little
    EXPECT_EQ(site.device_count(), 0u) << text;
    EXPECT_TRUE(script.ended) << text;
  }
}

TEST_F(Relay, a_frame_that_cannot_be_ends_the_connection) {
  Script script(network_);
  ASSERT_EQ(build(kWheels), "");
  script.greet();
  Bytes bytes = message(MessageType::kData, p2d::kCode, 5, 1);
  std::ranges::fill(std::span(bytes).last(4), std::byte{0x7f});
  script.say(bytes);
  network_.run();
  EXPECT_EQ(site.device_count(), 0u);
}

TEST_F(Relay, data_that_does_not_decode_is_left_out) {
  Script script(network_);
  ASSERT_EQ(build(kWheels), "");
  script.greet();
  TestClient client(network_, kHere);
  client.ask(push());
  client.ask(server::open_request(p2d::kCode, 0));
  script.say(message(MessageType::kData, p2d::kCode, 5, p2d::kDataState, Bytes(3)));
  script.say(message(MessageType::kData, p2d::kCode, 6, p2d::kDataState, wire::encode(p2d::Data{})));
  script.say(message(MessageType::kData, p2d::kCode, 5, p2d::kDataState, wire::encode(p2d::Data{})));
  EXPECT_EQ(server::outline(client.read()), "DATA 1 of 4");
}

TEST_F(Relay, answers_without_the_number_of_their_request_are_taken_in_order) {
  Script script(network_);
  ASSERT_EQ(build(kWheels), "");
  script.greet();
  TestClient client(network_, kHere);
  client.ask(message(MessageType::kReq, p2d::kCode, 0, p2d::kReqGetGeom, {}, 1));
  client.ask(message(MessageType::kReq, p2d::kCode, 0, p2d::kReqGetGeom, {}, 2));
  script.say(message(MessageType::kAck, p2d::kCode, 5, p2d::kReqGetGeom, wire::encode(p2d::Geom{})));
  const std::vector<Received> first = client.read();
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(first[0].header.seq, 1u);
  script.say(message(MessageType::kNack, p2d::kCode, 5, p2d::kReqGetGeom));
  EXPECT_EQ(client.read().at(0).header.seq, 2u);
  script.say(message(MessageType::kAck, p2d::kCode, 5, p2d::kReqGetGeom));  // that nobody asked for
  EXPECT_TRUE(client.read().empty());
}

/// A server that takes nothing while a client drives.
class PausedRelay : public Relay {
 protected:
  void SetUp() override {
    ASSERT_EQ(build(kWheels), "");
    script.greet();
    client = std::make_unique<TestClient>(network_, kHere);
    network_.run();
    script.one->pause();
    for (double speed = 1; speed <= kMost; ++speed) client->send(drive(speed));
  }
  /// What it gets once it takes something.
  std::vector<Received> heard() {
    network_.run();
    script.one->resume();
    script.heard.clear();
    network_.run();
    return server::cut_messages(script.heard);
  }

  static constexpr double kMost = 20000;  // commands of 68 bytes each: more than is under way
  Script script{network_};
  std::unique_ptr<TestClient> client;
};

TEST_F(PausedRelay, gets_the_newest_commands_once_it_takes_some) {
  const std::vector<Received> commands = heard();
  ASSERT_FALSE(commands.empty());
  EXPECT_LT(commands.size(), 16000u);
  EXPECT_EQ(wire::decode<p2d::CmdVel>(commands.back().body)->vel.px, kMost);
}

TEST_F(PausedRelay, is_asked_behind_the_commands_that_came_before) {
  client->send(ask(p2d::kReqGetGeom));
  const std::vector<Received> messages = heard();
  ASSERT_GT(messages.size(), 2u);
  EXPECT_EQ(messages.back().header.type, MessageType::kReq);
  EXPECT_EQ(wire::decode<p2d::CmdVel>(messages[messages.size() - 2].body)->vel.px, kMost);
  script.one.reset();
  network_.run();  // what was asked has its answer
}

TEST_F(Relay, files_that_make_no_sense_are_told_what) {
  const auto wrong = [&](const std::string& fields) {
    return build("driver( name \"passthrough\" " + fields + " )");
  };
  EXPECT_EQ(wrong("provides [\"laser:0\"]"),
            "test.cfg:1: driver \"passthrough\" requires devices of another server, e.g. "
            "[\"lab:6665:laser:0\"]");
  EXPECT_EQ(wrong("provides [\"laser:0\"] requires [\"lab:6665:ranger:0\"]"),
            "test.cfg:1: \"laser:0\" cannot stand for \"lab:6665:ranger:0\": a passthrough changes no "
            "interface");
  EXPECT_EQ(wrong("provides [\"laser:0\" \"laser:1\"] requires [\"lab:6665:laser:0\"]"),
            "test.cfg:1: 2 devices are provided and 1 required: each stands for one");
  EXPECT_EQ(wrong("provides [\"laser:0\" \"laser:1\"] requires [\"a:1:laser:0\" \"b:1:laser:0\"]"),
            "test.cfg:1: \"b:1:laser:0\" is of another server than \"a:1:laser:0\": write a section "
            "for each");
  EXPECT_EQ(wrong("provides [\"laser:0\"] requires [\"localhost:6665:laser:0\"]"),
            "test.cfg:1: \"laser:0\" would stand for itself");
  EXPECT_NE(wrong("provides [\"laser:0\"] requires [\"lab:6665:lasr:0\"]").find("(did you mean \"laser\"?)"),
            std::string::npos);
}

}  // namespace
}  // namespace playhouse::drivers
