// A relay between two servers over the simulated network: its clients are those of the one, its devices those
// of the other.

#include "playhouse/drivers/passthrough/passthrough.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>

#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/net/simulated.h"
#include "playhouse/server/fake_driver.h"
#include "playhouse/server/server.h"
#include "playhouse/server/test_client.h"
#include "playhouse/wire/generated/common.h"
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
constexpr const char* kRetiring =
    "driver( name \"passthrough\" provides [\"position2d:0\"] requires [\"lab:7000:position2d:5\"] reconnect "
    "0 )";

class Relay : public ::testing::Test, public Host {
 protected:
  Relay() {
    site.data_flow().pass_to(here);
    EXPECT_TRUE(here.listen(kHere));
  }
  // As programs end: whoever waits is answered while the server is there.
  ~Relay() override {
    for (const auto& driver : drivers) driver->finish();
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
  static Bytes open() { return server::open_request(p2d::kCode, 0); }
  std::size_t lab_sessions() const { return lab->status().sessions; }

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

TEST_F(Relay, the_server_of_a_section_may_have_an_address_of_ipv6) {
  open_lab();
  ASSERT_EQ(build("driver( name \"passthrough\" provides [\"position2d:0\"] "
                  "requires [\"[2001:db8::7]:7000:position2d:5\"] )"),
            "");
  EXPECT_EQ(drivers.front()->name(), "passthrough ([2001:db8::7]:7000)");
  TestClient client(network_, kHere);
  EXPECT_TRUE(is_open(client.ask(open())));
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

TEST_F(Relay, connects_when_a_device_is_opened_until_the_last_one_is_closed) {
  open_lab();
  ASSERT_TRUE(lab->add_device({kThere, lsr::kCode, 0}, laser));
  ASSERT_EQ(build("driver( name \"passthrough\" provides [\"position2d:0\" \"laser:0\"] "
                  "requires [\"lab:7000:position2d:5\" \"lab:7000:laser:0\"] )"),
            "");
  network_.run_for(10);
  EXPECT_EQ(lab->status().sessions_accepted, 0u);
  TestClient client(network_, kHere);
  EXPECT_TRUE(is_open(client.ask(open())));
  EXPECT_TRUE(is_open(client.ask(server::open_request(lsr::kCode, 0))));
  EXPECT_EQ(lab->status().sessions_accepted, 1u);
  client.ask(close_request());
  network_.run_for(10);
  EXPECT_EQ(lab_sessions(), 1u) << "the laser is open";
  client.ask(server::open_request(lsr::kCode, 0, 2));
  network_.run_for(2);
  EXPECT_EQ(lab_sessions(), 0u);
  EXPECT_TRUE(is_open(client.ask(open())));
  EXPECT_EQ(lab->status().sessions_accepted, 2u);
  EXPECT_EQ(wheels.starts, 2);
}

TEST_F(Relay, a_client_that_leaves_before_it_is_told_leaves_nothing_open) {
  open_lab();
  ASSERT_EQ(build(kWheels), "");
  {
    TestClient client(network_, kHere);
    network_.cut(1);
    client.send(open());
    client.peer.vanish();
  }
  network_.run_for(10);
  EXPECT_EQ(wheels.starts, wheels.stops);
  EXPECT_EQ(lab_sessions(), 0u);
}

TEST_F(Relay, what_a_client_says_behind_its_open_comes_behind_it) {
  open_lab();
  ASSERT_EQ(build(kWheels), "");
  TestClient client(network_, kHere);
  client.send(open());
  client.send(drive(0.5));
  const std::vector<Received> answers = client.ask(ask(p2d::kReqGetGeom));
  EXPECT_EQ(server::outline(answers), "ACK 3, NACK " + std::to_string(p2d::kReqGetGeom));
  EXPECT_EQ(wheels.commands.size(), 1u);
}

TEST_F(Relay, whoever_has_not_opened_a_device_commands_it_and_asks_it) {
  open_lab();
  wheels.answers[p2d::kReqGetGeom] = wire::encode(p2d::Geom{});
  ASSERT_EQ(build(kWheels), "");
  TestClient client(network_, kHere);
  EXPECT_EQ(client.ask(ask(p2d::kReqGetGeom)).at(0).header.type, MessageType::kAck);
  client.ask(drive(0.5));
  EXPECT_EQ(wheels.commands.size(), 1u);
  EXPECT_EQ(wheels.starts, 1);
  network_.run_for(2);
  EXPECT_EQ(wheels.stops, 1);
  EXPECT_EQ(lab_sessions(), 0u);
}

TEST_F(Relay, a_device_that_the_other_server_does_not_open_does_not_open_here) {
  open_lab();
  wheels.fails_to_start = true;
  ASSERT_EQ(build("driver( name \"passthrough\" provides [\"position2d:0\" \"laser:0\"] "
                  "requires [\"lab:7000:position2d:5\" \"lab:7000:laser:8\"] )"),
            "");
  TestClient client(network_, kHere);
  EXPECT_EQ(server::access_of(client.ask(open()).at(0)), 3);
  EXPECT_EQ(server::access_of(client.ask(server::open_request(lsr::kCode, 0)).at(0)), 3) << "there is none";
  wheels.fails_to_start = false;
  EXPECT_TRUE(is_open(client.ask(open())));
}

TEST_F(Relay, devices_retire_with_their_server_where_the_file_says_so) {
  open_lab();
  wheels.holds_requests = true;
  ASSERT_EQ(build(kRetiring), "");
  TestClient client(network_, kHere);
  client.ask(push());
  client.ask(open());
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

TEST_F(Relay, a_server_that_is_away_is_an_error_at_once_and_found_once_it_is_there) {
  ASSERT_EQ(build(kWheels), "");
  TestClient client(network_, kHere);
  EXPECT_EQ(server::access_of(client.ask(open()).at(0)), 3) << "nobody is there";
  open_lab();
  EXPECT_TRUE(is_open(client.ask(open())));
}

TEST_F(Relay, devices_outlive_a_loss_and_are_opened_again) {
  open_lab();
  ASSERT_EQ(build(kWheels), "");
  TestClient client(network_, kHere), later(network_, kHere);
  client.ask(push());
  ASSERT_TRUE(is_open(client.ask(open())));
  lab.reset();
  network_.run();
  EXPECT_EQ(site.device_count(), 1u);
  EXPECT_EQ(client.ask(ask(p2d::kReqGetGeom)).at(0).header.type, MessageType::kNack);
  EXPECT_EQ(server::access_of(later.ask(open()).at(0)), 3) << "it is away, whoever has it open";
  network_.run_for(20);
  open_lab();
  network_.run_for(40);
  EXPECT_EQ(wheels.starts, 2);
  const Bytes state = wire::encode(p2d::Data{{1, 2, 3}, {4, 5, 6}, 1});
  lab->publish({{wheels_id, p2d::kDataState, 12.5, state}});
  EXPECT_EQ(server::outline(client.read()), "DATA 1 of 4");
  EXPECT_TRUE(is_open(later.ask(open())));
}

TEST_F(Relay, whoever_opens_a_device_does_not_wait_for_the_next_attempt) {
  open_lab();
  ASSERT_EQ(build(kWheels), "");
  TestClient client(network_, kHere);
  ASSERT_TRUE(is_open(client.ask(open())));
  lab.reset();
  network_.run_for(100);  // half a minute from one attempt to the next
  open_lab();
  TestClient later(network_, kHere);
  EXPECT_TRUE(is_open(later.ask(open())));
  EXPECT_EQ(wheels.starts, 2);
}

TEST_F(Relay, a_device_that_comes_after_its_server_is_opened_again) {
  open_lab();
  ASSERT_EQ(build(kWheels), "");
  TestClient client(network_, kHere);
  ASSERT_TRUE(is_open(client.ask(open())));
  lab = std::make_unique<server::Server>(network_);
  EXPECT_TRUE(lab->listen(kThere));
  network_.run_for(5);
  wheels_id = *lab->add_device({kThere, p2d::kCode, 5}, wheels);
  network_.run_for(10);
  EXPECT_EQ(wheels.starts, 2);
}

TEST_F(Relay, nobody_looks_for_a_server_whose_last_user_has_left) {
  open_lab();
  ASSERT_EQ(build(kWheels), "");
  {
    TestClient client(network_, kHere);
    ASSERT_TRUE(is_open(client.ask(open())));
    lab.reset();
    network_.run_for(1);
    client.peer.finish();
  }
  network_.run_for(5);
  open_lab();
  network_.run_for(100);
  EXPECT_EQ(lab->status().sessions_accepted, 0u);
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

/// Asks a property, or sets it.
template <typename Request, typename Value>
Bytes property(std::uint8_t subtype, const std::string& key, Value value) {
  Request request;
  request.key = wire::c_string(key);
  request.value = value;
  return message(MessageType::kReq, p2d::kCode, 0, subtype, wire::encode(request));
}
Bytes set_number(const std::string& key, std::int32_t value) {
  return property<wire::IntpropReq>(wire::kReqSetIntprop, key, value);
}
Bytes set_host(const std::string& host) {
  return property<wire::StrpropReq>(wire::kReqSetStrprop, "remote_host", wire::c_string(host));
}

/// Whoever sets the property would have read the token at a server of his own.
TEST_F(Relay, a_token_goes_to_the_server_of_the_file_alone) {
  open_lab();
  std::vector<std::string> tokens;
  const auto admit = [&](const std::string& token, const std::string&) {
    tokens.push_back(token);
    return std::optional<device::Rights>(device::Rights());
  };
  server::Server other(network_);
  ASSERT_TRUE(other.listen(7001));
  lab->admit_by(admit);
  other.admit_by(admit);
  ASSERT_EQ(build("driver( name \"passthrough\" provides [\"position2d:0\"] "
                  "requires [\"lab:7000:position2d:5\"] token \"a-driver-\" )"),
            "");
  TestClient client(network_, kHere);
  EXPECT_EQ(client.ask(set_number("remote_port", 7001)).at(0).header.type, MessageType::kAck);
  client.ask(open());
  EXPECT_EQ(other.status().sessions_accepted, 1u);
  EXPECT_EQ(std::ranges::count(tokens, "a-driver-"), 0);
  EXPECT_EQ(client.ask(set_host("attic")).at(0).header.type, MessageType::kAck);
  EXPECT_EQ(client.ask(set_number("remote_port", 7000)).at(0).header.type, MessageType::kAck);
  client.ask(open());
  EXPECT_EQ(std::ranges::count(tokens, "a-driver-"), 0) << "as another machine";
  EXPECT_EQ(client.ask(set_host("lab")).at(0).header.type, MessageType::kAck);
  client.ask(open());
  EXPECT_EQ(std::ranges::count(tokens, "a-driver-"), 1) << "the file's own once more";
}

/// Each asked the other for ever, and so did every command.
TEST_F(Relay, two_that_stand_for_each_other_are_not_opened) {
  ASSERT_EQ(build("driver( name \"passthrough\" provides [\"position2d:0\" \"laser:0\"] "
                  "requires [\"here:6665:position2d:1\" \"here:6665:laser:3\"] )\n"
                  "driver( name \"passthrough\" provides [\"position2d:1\" \"laser:1\"] "
                  "requires [\"here:6665:position2d:0\" \"here:6665:laser:3\"] )"),
            "");
  TestClient client(network_, kHere);
  EXPECT_EQ(server::access_of(client.ask(open()).at(0)), 3);
  EXPECT_EQ(client.ask(ask(p2d::kReqGetGeom)).at(0).header.type, MessageType::kNack);
  EXPECT_EQ(server::access_of(client.ask(server::open_request(lsr::kCode, 0)).at(0)), 3)
      << "both lead to one that is absent";
}

TEST_F(Relay, a_hundred_devices_of_a_server_share_a_connection) {
  open_lab();
  std::string here_named, there_named;
  for (std::uint16_t i = 0; i < 100; ++i) {
    ASSERT_TRUE(lab->add_device({kThere, lsr::kCode, i}, laser));
    here_named += "\"laser:" + std::to_string(i) + "\" ";
    there_named += "\"lab:7000:laser:" + std::to_string(i) + "\" ";
  }
  ASSERT_EQ(
      build("driver( name \"passthrough\" provides [" + here_named + "] requires [" + there_named + "] )"),
      "");
  TestClient client(network_, kHere);
  for (std::uint16_t i = 0; i < 100; ++i) client.send(server::open_request(lsr::kCode, i));
  const std::vector<Received> answers = client.read();
  ASSERT_EQ(answers.size(), 100u);
  for (const Received& answer : answers) EXPECT_EQ(server::access_of(answer), 1);
  EXPECT_EQ(laser.starts, 100);
  EXPECT_EQ(lab->status().sessions_accepted, 1u);
}

TEST_F(Relay, clients_see_where_a_device_comes_from) {
  ASSERT_EQ(build(kWheels), "");
  TestClient client(network_, kHere);
  const Bytes asked = wire::encode(wire::player::DeviceDriverinfo{{0, 0, p2d::kCode, 0}, ""});
  const std::vector<Received> answer =
      client.ask(server::player_request(wire::player::kReqDriverinfo, asked));
  EXPECT_EQ(wire::text(wire::decode<wire::player::DeviceDriverinfo>(answer.at(0).body)->driver_name),
            "passthrough (lab:7000)");
}

TEST_F(Relay, a_server_whose_name_is_long_is_named_in_part) {
  ASSERT_EQ(build("driver( name \"passthrough\" provides [\"position2d:0\"] requires [\"" +
                  std::string(200, 'a') + ":7000:position2d:5\"] )"),
            "");
}

TEST_F(Relay, properties_of_a_proxy_move_it_to_another_server) {
  open_lab();
  FakeDriver other_wheels;
  server::Server other(network_);
  ASSERT_TRUE(other.listen(7001));
  ASSERT_TRUE(other.add_device({7001, p2d::kCode, 8}, other_wheels));
  ASSERT_EQ(build(kWheels), "");
  TestClient client(network_, kHere);
  ASSERT_TRUE(is_open(client.ask(open())));
  const auto number = [&](const std::string& key) {
    const std::vector<Received> answer = client.ask(property<wire::IntpropReq>(wire::kReqGetIntprop, key, 0));
    return wire::decode<wire::IntpropReq>(answer.at(0).body)->value;
  };
  EXPECT_EQ(number("remote_port"), 7000);
  EXPECT_EQ(number("remote_index"), 5);
  EXPECT_EQ(number("connect"), 1);

  EXPECT_EQ(client.ask(set_number("remote_port", 7001)).at(0).header.type, MessageType::kAck);
  EXPECT_EQ(wheels.stops, 1);
  EXPECT_EQ(other.status().sessions, 1u);
  EXPECT_EQ(client.ask(set_number("remote_index", 8)).at(0).header.type, MessageType::kAck);
  network_.run_for(1);
  EXPECT_EQ(other_wheels.starts, 1) << "which is open here";
  EXPECT_EQ(client.ask(set_number("connect", 0)).at(0).header.type, MessageType::kAck);
  network_.run_for(100);
  EXPECT_EQ(other.status().sessions, 0u);
  TestClient later(network_, kHere);
  EXPECT_EQ(server::access_of(later.ask(open()).at(0)), 3);
  EXPECT_EQ(client.ask(set_number("connect", 1)).at(0).header.type, MessageType::kAck);
  EXPECT_EQ(other_wheels.starts, 2);

  EXPECT_EQ(client.ask(set_host("attic")).at(0).header.type, MessageType::kAck);
  const Bytes asked = property<wire::StrpropReq>(wire::kReqGetStrprop, "remote_host", std::string());
  EXPECT_EQ(wire::text(wire::decode<wire::StrpropReq>(client.ask(asked).at(0).body)->value), "attic");
  EXPECT_EQ(drivers.front()->name(), "passthrough (attic:7001)");
  for (const std::int32_t no_port : {70000, 0, -1})
    EXPECT_EQ(client.ask(set_number("remote_port", no_port)).at(0).header.type, MessageType::kNack);
}

TEST_F(Relay, a_section_says_by_fields_what_its_device_stands_for) {
  open_lab();
  ASSERT_EQ(build("driver( name \"passthrough\" provides [\"position2d:0\"] requires [\"position2d:0\"] "
                  "remote_host \"lab\" remote_port 7000 remote_index 5 )"),
            "");
  EXPECT_EQ(drivers.front()->name(), "passthrough (lab:7000)");
  TestClient client(network_, kHere);
  EXPECT_TRUE(is_open(client.ask(open())));
  EXPECT_EQ(wheels.starts, 1);
}

TEST_F(Relay, a_section_may_start_disconnected) {
  open_lab();
  ASSERT_EQ(build("driver( name \"passthrough\" provides [\"position2d:0\"] "
                  "requires [\"lab:7000:position2d:5\"] connect 0 alwayson 1 )"),
            "");
  TestClient client(network_, kHere);
  EXPECT_EQ(server::access_of(client.ask(open()).at(0)), 3);
  network_.run_for(100);
  EXPECT_EQ(lab->status().sessions_accepted, 0u);
  EXPECT_EQ(client.ask(set_number("connect", 1)).at(0).header.type, MessageType::kAck);
  EXPECT_TRUE(is_open(client.ask(open())));
}

/// A ring that nobody saw when its first devices were opened.
TEST_F(Relay, a_proxy_that_is_moved_into_a_ring_is_not_open_any_more) {
  open_lab();
  ASSERT_EQ(
      build(
          "driver( name \"passthrough\" provides [\"position2d:0\"] requires [\"lab:7000:position2d:5\"] )"
          "driver( name \"passthrough\" provides [\"position2d:1\"] requires [\"here:6665:position2d:0\"] )"),
      "");
  TestClient client(network_, kHere);
  ASSERT_TRUE(is_open(client.ask(server::open_request(p2d::kCode, 1))));
  EXPECT_EQ(client.ask(set_number("remote_port", kHere)).at(0).header.type, MessageType::kAck);
  EXPECT_EQ(client.ask(set_number("remote_index", 1)).at(0).header.type, MessageType::kAck);
  network_.run_for(5);
  EXPECT_EQ(server::access_of(client.ask(open()).at(0)), 3);
  client.ask(drive(1));
  network_.run_for(100);
  EXPECT_EQ(wheels.commands.size(), 0u);
}

TEST_F(Relay, a_driver_that_is_always_on_waits_for_its_robot_and_starts) {
  ASSERT_EQ(build("driver( name \"vfh\" provides [\"position2d:1\"] requires [\"7000:position2d:5\" "
                  "\"7000:laser:0\"] alwayson 1 )"),
            "");
  network_.run_for(3);
  open_lab();
  ASSERT_TRUE(lab->add_device({kThere, lsr::kCode, 0}, laser));
  network_.run_for(10);
  EXPECT_EQ(wheels.starts, 1);
  EXPECT_EQ(laser.starts, 1);
  lab.reset();
  network_.run_for(3);
  open_lab();
  ASSERT_TRUE(lab->add_device({kThere, lsr::kCode, 0}, laser));
  network_.run_for(10);
  EXPECT_EQ(wheels.starts, 2);
  EXPECT_EQ(laser.starts, 2);
}

TEST_F(Relay, a_passthrough_that_is_always_on_stays_connected) {
  ASSERT_EQ(build("driver( name \"passthrough\" provides [\"position2d:0\" \"laser:0\"] "
                  "requires [\"lab:7000:position2d:5\" \"lab:7000:laser:0\"] alwayson 1 )"),
            "");
  network_.run_for(3);
  open_lab();
  network_.run_for(10);
  EXPECT_EQ(wheels.starts, 1) << "though there is no laser";
  ASSERT_TRUE(lab->add_device({kThere, lsr::kCode, 0}, laser));
  network_.run_for(30);
  EXPECT_EQ(laser.starts, 1);
  EXPECT_EQ(wheels.starts, 1);
  EXPECT_EQ(lab_sessions(), 1u);
}

/// position2d:0 stands for position2d:1, and so on, the last one for the `back`th.
std::string ring(int devices, int back) {
  std::string cfg;
  for (int i = 0; i < devices; ++i)
    cfg += "driver( name \"passthrough\" provides [\"position2d:" + std::to_string(i) +
           "\"] requires [\"here:6665:position2d:" + std::to_string(i + 1 < devices ? i + 1 : back) +
           "\"] )\n";
  return cfg;
}

TEST_F(Relay, no_device_of_a_ring_is_opened_in_any_order) {
  ASSERT_EQ(build(ring(3, 0)), "");
  TestClient client(network_, kHere);
  for (const std::vector<std::uint16_t>& order :
       {std::vector<std::uint16_t>{0, 1, 2}, {2, 1, 0}, {1, 0, 2}, {0, 0, 0}}) {
    for (const std::uint16_t device : order)
      EXPECT_EQ(server::access_of(client.ask(server::open_request(p2d::kCode, device)).at(0)), 3);
    for (const std::uint16_t device : order) client.send(server::open_request(p2d::kCode, device));
    EXPECT_EQ(client.read().size(), order.size()) << "all at a time, and without waiting";
    client.send(drive(1));
    client.send(ask(p2d::kReqGetGeom));
    EXPECT_EQ(server::outline(client.read()), "NACK " + std::to_string(p2d::kReqGetGeom));
    network_.run_for(10);
    EXPECT_EQ(here.status().sessions, 1u) << "the client";
    const std::uint64_t messages = here.status().messages_received;
    network_.run_for(100);
    EXPECT_EQ(here.status().messages_received, messages) << "nothing goes round";
  }
}

TEST_F(Relay, a_way_into_a_ring_is_not_opened) {
  ASSERT_EQ(build(ring(3, 1)), "");
  TestClient client(network_, kHere);
  EXPECT_EQ(server::access_of(client.ask(open()).at(0)), 3);
  EXPECT_EQ(client.ask(ask(p2d::kReqGetGeom)).at(0).header.type, MessageType::kNack);
}

TEST_F(Relay, a_way_through_eight_servers_is_opened_and_a_longer_one_is_not) {
  open_lab();
  ASSERT_EQ(build(ring(9, 9) + "driver( name \"passthrough\" provides [\"position2d:9\"] "
                               "requires [\"lab:7000:position2d:5\"] )"),
            "");
  TestClient client(network_, kHere);
  EXPECT_EQ(server::access_of(client.ask(open()).at(0)), 3);
  EXPECT_TRUE(is_open(client.ask(server::open_request(p2d::kCode, 1))));
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
  /// Opens position2d:5.
  void take_open() {
    say(message(MessageType::kAck, wire::player::kCode, 0, wire::player::kReqDev,
                wire::encode(wire::player::DeviceReq{{0, kThere, p2d::kCode, 5}, 1, ""})));
  }
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
  ASSERT_EQ(build(kWheels), "");
  for (const std::string_view text : {"HTTP/1.1 400 Bad Request\r\n", "Player w.3", "P\0"}) {
    Script script(network_);
    TestClient client(network_, kHere);
    client.ask(open());
    script.say(text);
    network_.run_for(11);  // for the last one, which says too little
    EXPECT_EQ(server::access_of(client.read().at(0)), 3) << text;
    EXPECT_TRUE(script.ended) << text;
  }
}

TEST_F(Relay, a_server_that_does_not_answer_is_waited_for_three_seconds) {
  Script script(network_);
  ASSERT_EQ(build(kWheels), "");
  TestClient client(network_, kHere);
  client.ask(open());
  script.greet();
  network_.run_for(2.9);
  EXPECT_TRUE(client.read().empty());
  network_.run_for(0.2);
  EXPECT_EQ(server::access_of(client.read().at(0)), 3);
  network_.run_for(2);
  EXPECT_TRUE(script.ended);
}

TEST_F(Relay, a_frame_that_cannot_be_ends_the_connection) {
  Script script(network_);
  ASSERT_EQ(build(kWheels), "");
  TestClient client(network_, kHere);
  client.ask(open());
  script.greet();
  Bytes bytes = message(MessageType::kData, p2d::kCode, 5, 1);
  std::ranges::fill(std::span(bytes).last(4), std::byte{0x7f});
  script.say(bytes);
  EXPECT_EQ(server::access_of(client.read().at(0)), 3);
  EXPECT_TRUE(script.ended);
}

TEST_F(Relay, data_that_does_not_decode_is_left_out) {
  Script script(network_);
  ASSERT_EQ(build(kWheels), "");
  TestClient client(network_, kHere);
  client.ask(push());
  client.ask(open());
  script.greet();
  script.take_open();
  ASSERT_TRUE(is_open(client.read()));
  script.say(message(MessageType::kData, p2d::kCode, 5, p2d::kDataState, Bytes(3)));
  script.say(message(MessageType::kData, p2d::kCode, 6, p2d::kDataState, wire::encode(p2d::Data{})));
  script.say(message(MessageType::kData, p2d::kCode, 5, p2d::kDataState, wire::encode(p2d::Data{})));
  EXPECT_EQ(server::outline(client.read()), "DATA 1 of 4");
}

TEST_F(Relay, answers_without_the_number_of_their_request_are_taken_in_order) {
  Script script(network_);
  ASSERT_EQ(build(kWheels), "");
  TestClient client(network_, kHere);
  client.ask(message(MessageType::kReq, p2d::kCode, 0, p2d::kReqGetGeom, {}, 1));
  client.ask(message(MessageType::kReq, p2d::kCode, 0, p2d::kReqGetGeom, {}, 2));
  script.greet();
  script.take_open();
  script.say(message(MessageType::kAck, p2d::kCode, 5, p2d::kReqGetGeom, wire::encode(p2d::Geom{})));
  const std::vector<Received> first = client.read();
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(first[0].header.seq, 1u);
  script.say(message(MessageType::kNack, p2d::kCode, 5, p2d::kReqGetGeom));
  EXPECT_EQ(client.read().at(0).header.seq, 2u);
  script.say(message(MessageType::kAck, p2d::kCode, 5, p2d::kReqGetGeom));  // that nobody asked for
  EXPECT_TRUE(client.read().empty());
}

/// A server of the original is not asked for circles: some of its drivers end with such a request.
TEST_F(Relay, a_server_of_the_original_is_asked_to_open_and_nothing_else) {
  Script script(network_);
  ASSERT_EQ(build(kWheels), "");
  TestClient client(network_, kHere);
  client.ask(open());
  script.greet();
  network_.run();
  EXPECT_EQ(server::outline(server::cut_messages(script.heard)), "REQ 5, REQ 3");  // DATAMODE, DEV
}

/// A server that takes nothing while a client drives.
class PausedRelay : public Relay {
 protected:
  void SetUp() override {
    ASSERT_EQ(build(kWheels), "");
    client = std::make_unique<TestClient>(network_, kHere);
    client->ask(open());
    script.greet();
    script.take_open();
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
  EXPECT_EQ(wrong("provides [\"laser:0\"] requires [\"lab:0:laser:0\"]"),
            "test.cfg:1: \"lab:0:laser:0\" has an invalid port: 1 to 65535 is valid");
  EXPECT_EQ(wrong("provides [\"laser:0\"] requires [\"lab:1:laser:0\"] remote_index 65536"),
            "test.cfg:1: remote_index is from 0 to 65535");
  EXPECT_EQ(wrong("provides [\"laser:0\"] requires [\"lab:1:laser:0\"] remote_port 0"),
            "test.cfg:1: remote_port is from 1 to 65535");
  EXPECT_EQ(wrong("provides [\"laser:0\" \"laser:1\"] requires [\"a:1:laser:0\" \"a:1:laser:1\"] "
                  "remote_index 3"),
            "test.cfg:1: 2 devices are required and 1 indices given: one is of each");
  EXPECT_NE(wrong("provides [\"laser:0\"] requires [\"lab:6665:lasr:0\"]").find("(did you mean \"laser\"?)"),
            std::string::npos);
}

}  // namespace
}  // namespace playhouse::drivers
