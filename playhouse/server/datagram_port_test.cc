// Sessions over UDP, on the simulated network, whose datagrams get lost as told. Real sockets: server_tcp_test.cc.

#include "playhouse/server/datagram_port.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/server/fake_driver.h"
#include "playhouse/server/server.h"
#include "playhouse/server/test_client.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::server {
namespace {

namespace position2d = wire::position2d;
constexpr std::uint16_t kWheels = position2d::kCode, kLaser = wire::laser::kCode;
constexpr std::uint16_t kPort = 6665;

/// A client's socket, which keeps each datagram.
class DatagramClient {
 public:
  explicit DatagramClient(net::SimulatedNetwork& network, const std::string& host = "10.0.0.7")
      : network_(network),
        socket_(
            *network.open_datagrams(host, 0, [this](const net::Endpoint&, std::span<const std::byte> bytes) {
              datagrams.emplace_back(bytes.begin(), bytes.end());
            })) {}

  void send(const Bytes& bytes) { socket_->send(*net::parse_endpoint("127.0.0.1", kPort), bytes); }
  /// What comes within a second.
  std::vector<Received> read() {
    network_.run_for(1);
    std::vector<Received> messages;
    for (Bytes& each : datagrams) {
      if (each.size() == limits::kBannerBytes) {
        ++banners;
        continue;
      }
      if (each.empty()) continue;  // goodbye
      const std::vector<Received> cut = cut_messages(each);
      EXPECT_EQ(cut.size(), 1u) << "one message in each datagram";
      EXPECT_TRUE(each.empty());
      messages.insert(messages.end(), cut.begin(), cut.end());
    }
    datagrams.clear();
    return messages;
  }
  std::vector<Received> ask(const Bytes& bytes) {
    send(bytes);
    return read();
  }

  std::vector<Bytes> datagrams;
  int banners = 0;

 private:
  net::SimulatedNetwork& network_;
  std::unique_ptr<net::DatagramSocket> socket_;
};

class DatagramSessions : public ::testing::Test {
 protected:
  DatagramSessions() {
    EXPECT_EQ(*server.listen(kPort), kPort);
    wheels_id = *server.add_device({kPort, kWheels, 0}, wheels);
    laser_id = *server.add_device({kPort, kLaser, 0}, laser);
    wheels.answers[position2d::kReqGetGeom] = wire::encode(position2d::Geom{});
  }
  void publish(double time, std::size_t bytes = 52) {
    std::vector<device::Publication> batch;
    batch.push_back({laser_id, 1, time, Bytes(bytes)});
    server.publish(std::move(batch));
  }
  /// One that has begun its session and has this device open.
  void begin(DatagramClient& client, std::uint16_t interf) {
    EXPECT_TRUE(client.ask({}).empty());
    EXPECT_EQ(client.banners, 1);
    EXPECT_EQ(outline(client.ask(open_request(interf, 0))), "ACK 3");
  }

  net::SimulatedNetwork network{11};
  FakeDriver wheels{"stage"}, laser{"stage"};
  Server server{network, {.datagrams = true}};
  device::DeviceId wheels_id, laser_id;
};

TEST_F(DatagramSessions, begin_with_an_empty_datagram_and_carry_requests_commands_and_numbered_data) {
  DatagramClient client(network);
  begin(client, kWheels);
  EXPECT_EQ(outline(client.ask(message(wire::MessageType::kReq, kWheels, 0, position2d::kReqGetGeom))),
            "ACK " + std::to_string(position2d::kReqGetGeom));
  EXPECT_TRUE(client
                  .ask(message(wire::MessageType::kCmd, kWheels, 0, position2d::kCmdVel,
                               wire::encode(position2d::CmdVel{})))
                  .empty());
  EXPECT_EQ(wheels.commands.size(), 1u);
  EXPECT_EQ(outline(client.ask(open_request(kLaser, 0))), "ACK 3");
  for (int i = 0; i < 3; ++i) publish(10 + i);
  const std::vector<Received> data = client.read();
  ASSERT_EQ(data.size(), 3u);
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(data[i].header.seq, i + 1);
  EXPECT_EQ(server.status().sessions, 1u);
  EXPECT_EQ(server.status().datagrams.received, 5u);
}

TEST_F(DatagramSessions, answer_a_message_of_a_stranger_by_the_banner_alone) {
  DatagramClient client(network);
  EXPECT_TRUE(client.ask(open_request(kWheels, 0)).empty());
  EXPECT_EQ(client.banners, 1);
  EXPECT_EQ(wheels.starts, 0);
  EXPECT_EQ(outline(client.ask(open_request(kWheels, 0))), "ACK 3");
  EXPECT_EQ(server.status().datagrams.dropped, 1u);
}

TEST_F(DatagramSessions, begin_anew_with_a_further_empty_datagram) {
  DatagramClient client(network);
  begin(client, kWheels);
  EXPECT_EQ(wheels.starts, 1);
  client.ask({});
  EXPECT_EQ(client.banners, 2);
  EXPECT_EQ(wheels.stops, 1) << "the old session had it open";
  EXPECT_EQ(server.status().sessions, 1u);
  EXPECT_EQ(outline(client.ask(open_request(kWheels, 0))), "ACK 3");
}

TEST_F(DatagramSessions, lose_data_of_which_their_readers_know_and_go_on) {
  DatagramClient client(network);
  begin(client, kLaser);
  network.datagrams.loss = 0.3;
  for (int i = 0; i < 1000; ++i) {
    publish(10 + i);
    network.run_for(0.1);
  }
  network.datagrams.loss = 0;
  publish(2000);
  const std::vector<Received> data = client.read();
  EXPECT_EQ(data.back().header.seq, 1001u);
  EXPECT_GT(data.size(), 600u);
  EXPECT_LT(data.size(), 800u);
  EXPECT_EQ(outline(client.ask(open_request(kWheels, 0))), "ACK 3");
}

TEST_F(DatagramSessions, of_several_clients_are_apart) {
  DatagramClient one(network), other(network), third(network, "10.0.0.8");
  begin(one, kWheels);
  begin(other, kLaser);
  begin(third, kLaser);
  publish(10);
  EXPECT_TRUE(one.read().empty());
  EXPECT_EQ(other.read().size(), 1u);
  EXPECT_EQ(third.read().size(), 1u);
  EXPECT_EQ(server.status().sessions, 3u);
}

TEST_F(DatagramSessions, drop_what_no_datagram_holds_and_refuse_such_an_answer) {
  wheels.answers[position2d::kReqGetGeom] = Bytes(limits::kDatagramMostBytes);
  DatagramClient client(network);
  begin(client, kWheels);
  EXPECT_EQ(
      outline(client.ask(message(wire::MessageType::kReq, kWheels, 0, position2d::kReqGetGeom, {}, 42))),
      "NACK " + std::to_string(position2d::kReqGetGeom));
  EXPECT_EQ(outline(client.ask(open_request(kLaser, 0))), "ACK 3");
  publish(10, limits::kDatagramMostBytes);
  publish(11, limits::kDatagramMostBytes - limits::kHeaderBytes);
  const std::vector<Received> data = client.read();
  ASSERT_EQ(data.size(), 1u);
  EXPECT_EQ(data[0].header.seq, 2u) << "the reader knows that one is missing";
  EXPECT_EQ(server.status().datagrams.too_long, 2u);
}

TEST_F(DatagramSessions, end_when_nothing_was_heard_of_their_client_for_long) {
  DatagramClient client(network), speaker(network);
  begin(client, kWheels);
  begin(speaker, kWheels);
  network.run_for(limits::kDatagramSilentSeconds / 2);
  speaker.ask(player_request(wire::player::kReqDevlist));
  network.run_for(limits::kDatagramSilentSeconds / 2 + 61);
  EXPECT_EQ(server.status().sessions, 1u);
  EXPECT_EQ(server.status().datagrams.silent, 1u);
  EXPECT_EQ(outline(speaker.ask(open_request(kLaser, 0))), "ACK 3");
}

TEST_F(DatagramSessions, end_soon_when_they_command_and_nothing_shows_that_they_are_there) {
  const auto command =
      message(wire::MessageType::kCmd, kWheels, 0, position2d::kCmdVel, wire::encode(position2d::CmdVel{}));
  DatagramClient blind(network), speaker(network), reader(network), idle(network);
  for (DatagramClient* const client : {&blind, &speaker, &idle}) begin(*client, kWheels);
  begin(reader, kLaser);
  for (DatagramClient* const client : {&blind, &speaker, &reader}) client->send(command);
  for (int second = 0; second < limits::kDatagramBlindSeconds + 3; ++second) {
    speaker.send(command);
    publish(second);
    network.run_for(1);
  }
  EXPECT_EQ(server.status().sessions, 3u);
  EXPECT_EQ(outline(blind.ask(open_request(kLaser, 0))), "") << "it has to begin anew";
}

TEST_F(DatagramSessions, give_way_to_each_other_and_to_nobody_else_when_there_are_too_many) {
  std::vector<std::unique_ptr<TestClient>> by_tcp;
  by_tcp.push_back(std::make_unique<TestClient>(network, kPort));
  EXPECT_EQ(outline(by_tcp[0]->ask(open_request(kWheels, 0))), "ACK 3");
  std::vector<std::unique_ptr<DatagramClient>> many;
  for (std::size_t i = 0; i < limits::kDatagramSessions + 100; ++i) {
    many.push_back(std::make_unique<DatagramClient>(network, "10.1.0." + std::to_string(i / 1000)));
    many.back()->send({});
    network.run_for(0.02);
    many.back()->send(player_request(wire::player::kReqDevlist));
    network.run_for(0.02);
  }
  EXPECT_LE(server.status().sessions, limits::kDatagramSessions + 1);
  EXPECT_EQ(outline(many.back()->ask(open_request(kLaser, 0))), "ACK 1, ACK 3");
  by_tcp.push_back(std::make_unique<TestClient>(network, kPort));
  EXPECT_EQ(by_tcp[1]->banner.size(), 32u) << "there is room for others";
  EXPECT_EQ(outline(by_tcp[0]->ask(open_request(kLaser, 0))), "ACK 3");
}

TEST_F(DatagramSessions, hold_no_more_of_unfinished_messages_together_than_a_part_of_the_budget) {
  std::vector<std::unique_ptr<DatagramClient>> many;
  const Bytes begun = message(wire::MessageType::kReq, kWheels, 0, position2d::kReqGetGeom, Bytes(200000));
  const Bytes part(begun.begin(), begun.begin() + 60000);
  for (int i = 0; i < 400; ++i) {
    many.push_back(std::make_unique<DatagramClient>(network, "10.1.0.1"));
    many.back()->send({});
    many.back()->send(player_request(wire::player::kReqDevlist));
    network.run_for(0.02);
    many.back()->send(part);
  }
  network.run_for(1);
  constexpr std::size_t kFit = limits::kInputBytes / 8 / 60000;
  EXPECT_GE(server.status().datagrams.dropped, 400 - kFit - 1);
  many.clear();
  DatagramClient after(network, "10.0.0.9");
  begin(after, kWheels);
}

TEST_F(DatagramSessions, say_goodbye_by_an_empty_datagram) {
  DatagramClient client(network);
  begin(client, kWheels);
  server.finish([] {});
  network.run_for(3);
  const bool empty = std::ranges::any_of(client.datagrams, [](const Bytes& each) { return each.empty(); });
  EXPECT_TRUE(empty);
}

TEST_F(DatagramSessions, that_have_said_nothing_take_no_room_of_others) {
  DatagramClient speaker(network);
  begin(speaker, kWheels);
  std::vector<std::unique_ptr<DatagramClient>> forged;
  for (int i = 0; i < 1000; ++i) {
    forged.push_back(std::make_unique<DatagramClient>(
        network, "10.1." + std::to_string(i / 250) + "." + std::to_string(i % 250 + 1)));
    forged.back()->send({});
  }
  network.run_for(1);
  EXPECT_LE(server.status().sessions, 257u);
  EXPECT_EQ(outline(speaker.ask(open_request(kLaser, 0))), "ACK 3");
  EXPECT_EQ(outline(forged.back()->ask(open_request(kLaser, 0))), "ACK 3") << "the newest of them";
}

TEST_F(DatagramSessions, hold_no_more_for_a_client_that_outruns_its_session_than_the_limit) {
  wheels.holds_requests = true;
  DatagramClient client(network);
  begin(client, kWheels);
  const Bytes ask = message(wire::MessageType::kReq, kWheels, 0, position2d::kReqGetGeom, Bytes(1000));
  for (int i = 0; i < 5000; ++i) client.send(ask);
  network.run_for(1);
  EXPECT_GT(server.status().datagrams.dropped, 0u);
  EXPECT_GE(wheels.held.size(), 200u);
  wheels.holds_requests = false;
  wheels.held.clear();
  client.read();
  EXPECT_EQ(outline(client.ask(open_request(kLaser, 0))), "ACK 3");
}

TEST_F(DatagramSessions, accept_nobody_and_flush_at_the_end_of_the_run) {
  DatagramClient reader(network), late(network);
  begin(reader, kLaser);
  publish(10);
  bool done = false;
  server.finish([&] { done = true; });
  EXPECT_TRUE(late.ask({}).empty());
  EXPECT_EQ(late.banners, 0);
  EXPECT_EQ(reader.read().size(), 1u);
  network.run_for(3);
  EXPECT_TRUE(done);
}

}  // namespace
}  // namespace playhouse::server
