// Devices that come and go while clients are connected, over the simulated network: who is told what, and
// that nothing is left of them. Out of scope here: the order within one queue (out_queue_test.cc).

#include <gtest/gtest.h>

#include <memory>

#include "playhouse/server/fake_driver.h"
#include "playhouse/server/server.h"
#include "playhouse/server/test_client.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::server {
namespace {

constexpr std::uint16_t kWheels = wire::position2d::kCode, kLaser = wire::laser::kCode, kPort = 6665;
constexpr std::uint8_t kPull = 2, kGetGeom = wire::position2d::kReqGetGeom;

Bytes ask_geometry(std::uint16_t interf, std::uint16_t index) {
  return message(wire::MessageType::kReq, interf, index, kGetGeom, {}, 7);
}
Bytes drive(std::uint16_t index) {
  return message(wire::MessageType::kCmd, kWheels, index, wire::position2d::kCmdVel,
                 wire::encode(wire::position2d::CmdVel{}));
}
Bytes ask_round() {
  return player_request(wire::player::kReqData);
}

/// "4:0 e" for the notice that the device of interface 4 and index 0 has retired.
std::string told(const Received& notice) {
  EXPECT_EQ(notice.header.type, wire::MessageType::kAck);
  EXPECT_EQ(notice.header.interf, wire::player::kCode);
  EXPECT_EQ(notice.header.index, 0u);
  EXPECT_EQ(notice.header.subtype, wire::player::kReqDev);
  const auto body = wire::decode<wire::player::DeviceReq>(notice.body);
  if (!body) return body.error().text;
  EXPECT_EQ(body->addr.robot, kPort);
  return std::to_string(body->addr.interf) + ":" + std::to_string(body->addr.index) + " " +
         static_cast<char>(body->access);
}

class Retire : public ::testing::Test {
 protected:
  Retire() {
    EXPECT_EQ(*server.listen(kPort), kPort);
    wheels = std::make_unique<FakeDriver>("wheels");
    wheels->answers[kGetGeom] = wire::encode(wire::position2d::Geom{});
    wheels_id = *server.add_device({kPort, kWheels, 0}, *wheels);
    laser_id = *server.add_device({kPort, kLaser, 0}, laser);
  }
  void publish(device::DeviceId id, std::size_t bytes = 52) {
    std::vector<device::Publication> batch;
    batch.push_back({id, 1, ++time, Bytes(bytes)});
    server.publish(std::move(batch));
  }
  /// As whoever owns the driver does it.
  void retire_wheels() {
    server.retire_device(wheels_id);
    wheels.reset();
  }
  static std::size_t listed(TestClient& client) {
    const auto replies = client.ask(player_request(wire::player::kReqDevlist));
    return wire::decode<wire::player::DeviceDevlist>(replies.at(0).body)->devices.size();
  }
  static TestClient& opened(TestClient& client, std::uint16_t interf, std::uint8_t access = 1) {
    EXPECT_EQ(outline(client.ask(open_request(interf, 0, access))), "ACK 3");
    return client;
  }

  net::SimulatedNetwork network{13};
  std::unique_ptr<FakeDriver> wheels;
  FakeDriver laser{"laser"};
  Server server{network};
  device::DeviceId wheels_id, laser_id;
  double time = 0;
};

TEST_F(Retire, tells_every_client_that_has_the_device_open_and_nobody_else) {
  TestClient reader(network, kPort), writer(network, kPort), other(network, kPort);
  opened(opened(reader, kWheels), kWheels);
  opened(writer, kWheels, 'w');
  opened(other, kLaser);
  retire_wheels();
  const auto got = reader.read();
  ASSERT_EQ(outline(got), "ACK 3");
  EXPECT_EQ(told(got[0]), "4:0 e");
  EXPECT_EQ(wire::decode<wire::player::DeviceReq>(got[0].body)->driver_name, wire::c_string("wheels"));
  EXPECT_EQ(outline(writer.read()), "ACK 3");
  EXPECT_EQ(outline(other.read()), "");
}

TEST_F(Retire, leaves_no_device_at_the_address) {
  TestClient client(network, kPort);
  opened(client, kWheels);
  EXPECT_EQ(listed(client), 2u);
  retire_wheels();
  client.read();
  EXPECT_EQ(listed(client), 1u);
  const Bytes driver_request = player_request(
      wire::player::kReqDriverinfo, wire::encode(wire::player::DeviceDriverinfo{{0, 0, kWheels, 0}, ""}));
  EXPECT_EQ(outline(client.ask(driver_request)), "NACK 2");
  EXPECT_EQ(outline(client.ask(ask_geometry(kWheels, 0))), "NACK 1");
  EXPECT_EQ(outline(client.ask(drive(0))), "");
  EXPECT_EQ(server.status().commands_dropped, 1u);
  EXPECT_EQ(outline(client.ask(open_request(kWheels, 0))), "NACK 3");
  const auto closing = client.ask(open_request(kWheels, 0, 2));
  EXPECT_EQ(outline(closing), "NACK 3");
  EXPECT_EQ(access_of(closing.at(0)), wire::player::kErrorMode);
  EXPECT_FALSE(server.has_readers(wheels_id));
}

TEST_F(Retire, delivers_what_was_published_before_and_drops_what_comes_later) {
  TestClient client(network, kPort);
  opened(client, kWheels);
  publish(wheels_id);
  publish(wheels_id);
  retire_wheels();
  publish(wheels_id);
  EXPECT_EQ(outline(client.read()), "DATA 1 of 4, DATA 1 of 4, ACK 3");
  EXPECT_EQ(server.status().device_rows, 1u) << "the laser";
}

TEST_F(Retire, tells_a_client_in_pull_mode_amid_a_round_only) {
  TestClient client(network, kPort);
  client.ask(mode_request(kPull));
  opened(opened(client, kWheels), kLaser);
  publish(wheels_id);
  retire_wheels();
  publish(laser_id);
  EXPECT_EQ(outline(client.read()), "");
  EXPECT_EQ(outline(client.ask(player_request(wire::player::kReqDevlist))), "ACK 1");
  EXPECT_EQ(outline(client.ask(ask_round())), "ACK 4, DATA 1 of 4, ACK 3, DATA 1 of 6, SYNCH 1");
}

TEST_F(Retire, answers_requests_under_way_once_and_tells_behind_the_answers) {
  TestClient client(network, kPort), stranger(network, kPort);
  opened(client, kWheels);
  wheels->holds_requests = true;
  EXPECT_EQ(outline(client.ask(ask_geometry(kWheels, 0))), "");
  EXPECT_EQ(outline(stranger.ask(ask_geometry(kWheels, 0))), "");
  ASSERT_EQ(wheels->held.size(), 2u);
  std::vector<device::Replier> late = std::move(wheels->held);
  retire_wheels();
  for (device::Replier& replier : late) replier.ack(Bytes(72));
  const auto got = client.read();
  ASSERT_EQ(outline(got), "NACK 1, ACK 3");
  EXPECT_EQ(got[0].header.seq, 7u);
  EXPECT_EQ(outline(stranger.read()), "NACK 1");
}

TEST_F(Retire, holds_its_notice_back_while_another_device_owes_an_answer) {
  TestClient client(network, kPort);
  opened(client, kWheels);
  laser.holds_requests = true;
  client.ask(message(wire::MessageType::kReq, kLaser, 0, wire::laser::kReqGetGeom));
  retire_wheels();
  EXPECT_EQ(outline(client.read()), "");
  laser.held.clear();
  const auto got = client.read();
  ASSERT_EQ(got.size(), 2u);
  EXPECT_EQ(got[0].header.interf, wire::player::kCode);
  EXPECT_EQ(got[1].header.interf, kLaser);
}

TEST_F(Retire, gives_the_answers_that_the_driver_gave_before) {
  TestClient client(network, kPort);
  wheels->holds_requests = true;
  client.ask(ask_geometry(kWheels, 0));
  wheels->held.at(0).ack(Bytes(72));
  retire_wheels();
  EXPECT_EQ(outline(client.read()), "ACK 1");
}

TEST_F(Retire, stops_an_open_device_once_and_ends_the_holds_of_drivers) {
  FakeDriver holder, other_holder;
  TestClient client(network, kPort);
  opened(client, kWheels);
  ASSERT_TRUE(server.hold(wheels_id));
  ASSERT_TRUE(server.hold(wheels_id, &holder));
  ASSERT_TRUE(server.hold(wheels_id, &other_holder));
  server.release(wheels_id, &other_holder);
  EXPECT_EQ(wheels->starts, 1);
  server.retire_device(wheels_id);
  EXPECT_EQ(wheels->stops, 1);
  EXPECT_EQ(holder.lost_holds, 1);
  EXPECT_EQ(other_holder.lost_holds, 0);
  server.release(wheels_id);
  server.release(wheels_id, &holder);
  server.retire_device(wheels_id);
  EXPECT_EQ(wheels->stops, 1);
  EXPECT_EQ(holder.lost_holds, 1);
  EXPECT_FALSE(server.hold(wheels_id, &holder));
}

TEST_F(Retire, gives_the_address_to_another_device_and_nothing_of_the_old_one) {
  TestClient client(network, kPort), late(network, kPort);
  client.ask(mode_request(kPull));
  late.ask(mode_request(kPull));
  opened(client, kWheels);
  for (int i = 0; i < 3; ++i) publish(wheels_id, 52);
  retire_wheels();
  FakeDriver heir{"heir"};
  const device::DeviceId heir_id = *server.add_device({kPort, kWheels, 0}, heir);
  publish(wheels_id, 52);
  publish(heir_id, 80);
  opened(late, kWheels);
  const auto reopened = client.ask(open_request(kWheels, 0));
  ASSERT_EQ(outline(reopened), "ACK 3, ACK 3");
  EXPECT_EQ(told(reopened[0]), "4:0 e");
  EXPECT_EQ(access_of(reopened[1]), 1);
  publish(heir_id, 80);
  for (TestClient* each : {&client, &late}) {
    const auto got = each->ask(ask_round());
    ASSERT_EQ(outline(got), "ACK 4, DATA 1 of 4, SYNCH 1");
    EXPECT_EQ(got[1].body.size(), 80u);
  }
  server.retire_device(heir_id);
}

TEST_F(Retire, lets_no_client_command_or_ask_the_next_at_an_address_before_it_was_told) {
  TestClient client(network, kPort), other(network, kPort);
  client.ask(mode_request(kPull));
  opened(client, kWheels);
  retire_wheels();
  FakeDriver heir{"heir"};
  heir.answers[kGetGeom] = wire::encode(wire::position2d::Geom{});
  const device::DeviceId heir_id = *server.add_device({kPort, kWheels, 0}, heir);
  client.ask(drive(0));
  EXPECT_EQ(outline(client.ask(ask_geometry(kWheels, 0))), "NACK 1");
  EXPECT_EQ(heir.commands.size(), 0u);
  EXPECT_EQ(server.status().commands_dropped, 1u);
  other.ask(drive(0));
  EXPECT_EQ(heir.commands.size(), 1u) << "of a client that never had the first";

  EXPECT_EQ(outline(client.ask(ask_round())), "ACK 4, ACK 3");
  client.ask(drive(0));
  EXPECT_EQ(outline(client.ask(ask_geometry(kWheels, 0))), "ACK 1");
  EXPECT_EQ(heir.commands.size(), 2u);
  server.retire_device(heir_id);
}

TEST_F(Retire, says_nothing_to_a_client_that_is_gone) {
  TestClient client(network, kPort);
  opened(client, kWheels);
  wheels->holds_requests = true;
  client.ask(ask_geometry(kWheels, 0));
  client.peer.vanish();
  network.run();
  retire_wheels();
  network.run();
  EXPECT_EQ(server.status().sessions, 0u);
  EXPECT_EQ(server.status().device_rows, 1u) << "the laser";
}

TEST_F(Retire, holds_up_no_end_of_the_run) {
  TestClient client(network, kPort);
  client.ask(mode_request(kPull));
  opened(client, kWheels);
  retire_wheels();
  bool finished = false;
  server.finish([&] { finished = true; });
  network.run();
  EXPECT_TRUE(finished);
}

// Notices that are not read count as open devices, so that nothing grows for a client that never reads.
TEST_F(Retire, lets_no_client_open_more_devices_while_too_many_have_retired_unread) {
  TestClient client(network, kPort);
  client.ask(mode_request(kPull));
  for (std::size_t i = 0; i < limits::kSubscriptions; ++i) {
    const auto index = static_cast<std::uint16_t>(1 + i);
    const device::DeviceId id = *server.add_device({kPort, kWheels, index}, laser);
    EXPECT_EQ(access_of(client.ask(open_request(kWheels, index)).at(0)), 1);
    server.retire_device(id);
  }
  EXPECT_EQ(access_of(client.ask(open_request(kLaser, 0)).at(0)), wire::player::kErrorMode);
  EXPECT_EQ(client.ask(ask_round()).size(), 1 + limits::kSubscriptions);
  EXPECT_EQ(access_of(client.ask(open_request(kLaser, 0)).at(0)), 1);
}

/// A driver that holds another device while its own is open.
struct Holder final : device::Driver {
  Holder(Server& its_server, device::DeviceId its_device) : server(its_server), held(its_device) {}
  Server& server;
  device::DeviceId held;
  std::string_view name() const override { return "holder"; }
  Result<void> start(device::DeviceId) override { return server.hold(held, this); }
  void stop(device::DeviceId) override { server.release(held, this); }
  device::Taken command(const device::Message&) override { return device::Taken::kNo; }
  void request(const device::Message&, device::Replier) override {}
  bool capable(device::DeviceId, std::uint8_t, std::uint8_t) const override { return false; }
};

TEST(RetireHolder, releases_what_it_holds_when_its_own_device_retires_and_when_the_server_ends) {
  net::SimulatedNetwork network(1);
  FakeDriver wheels;
  std::optional<Holder> first, second;
  Server server(network);
  const device::DeviceId held = *server.add_device({kPort, kWheels, 0}, wheels);
  first.emplace(server, held);
  second.emplace(server, held);
  const device::DeviceId id = *server.add_device({kPort, kLaser, 0}, *first);
  ASSERT_TRUE(server.hold(id));
  ASSERT_TRUE(server.hold(*server.add_device({kPort, kLaser, 1}, *second)));
  server.retire_device(id);
  EXPECT_EQ(wheels.stops, 0) << "the second holds it";
  first.reset();
}

/// What a client in either mode hears while thousands of devices come and go.
class Churn : public Retire {
 protected:
  /// How much of it was about devices of the wheels' interface.
  void hear(TestClient& client, bool pull) {
    if (pull) client.send(ask_round());
    for (const Received& received : client.read()) {
      data += received.header.type == wire::MessageType::kData && received.header.interf == kWheels;
      notices += received.header.type == wire::MessageType::kAck &&
                 received.header.subtype == wire::player::kReqDev && access_of(received) == 'e';
    }
  }
  std::size_t data = 0, notices = 0;
};

TEST_F(Churn, of_thousands_of_devices_loses_no_data_and_leaves_nothing) {
  constexpr std::size_t kDevices = 3000, kPublished = 3;
  TestClient pushed(network, kPort), pulled(network, kPort);
  pulled.ask(mode_request(kPull));
  for (TestClient* client : {&pushed, &pulled}) opened(*client, kLaser);
  publish(laser_id);
  hear(pushed, false);
  hear(pulled, true);
  const std::size_t rows_before = server.status().device_rows;
  for (std::size_t i = 0; i < kDevices; ++i) {
    const auto index = static_cast<std::uint16_t>(1 + i % 16);  // each address is used by many
    auto driver = std::make_unique<FakeDriver>();
    driver->holds_requests = true;
    const device::DeviceId id = *server.add_device({kPort, kWheels, index}, *driver);
    for (TestClient* client : {&pushed, &pulled}) {
      ASSERT_EQ(access_of(client->ask(open_request(kWheels, index)).back()), 1);
      client->ask(ask_geometry(kWheels, index));
    }
    for (std::size_t n = 0; n < kPublished; ++n) publish(id);
    server.retire_device(id);
    driver.reset();
    publish(laser_id);
    hear(pushed, false);
    hear(pulled, true);
  }
  EXPECT_EQ(data, 2 * kDevices * kPublished);
  EXPECT_EQ(notices, 2 * kDevices);
  const ServerStatus status = server.status();
  EXPECT_EQ(status.devices_retired, kDevices);
  EXPECT_EQ(status.devices, 2u);
  EXPECT_EQ(status.device_rows, rows_before);
  EXPECT_EQ(status.output_bytes, 0u);
  EXPECT_EQ(status.data_dropped, 0u);
}

TEST_F(Churn, of_devices_that_clients_close_or_leave_open_at_their_end_leaves_nothing) {
  const std::size_t rows_before = server.status().device_rows;
  for (std::uint16_t i = 1; i <= 500; ++i) {
    FakeDriver driver;
    const device::DeviceId id = *server.add_device({kPort, kWheels, i}, driver);
    TestClient client(network, kPort);
    client.ask(open_request(kWheels, i));
    publish(id);
    if (i % 3 == 0) client.ask(open_request(kWheels, i, 2));
    if (i % 3 == 1) client.peer.vanish();
    network.run();
    server.retire_device(id);
    client.peer.vanish();
    network.run();
  }
  EXPECT_EQ(server.status().device_rows, rows_before);
  EXPECT_EQ(server.status().output_bytes, 0u);
}

}  // namespace
}  // namespace playhouse::server
