// The whole server over the simulated network: what clients see. Out of scope here: sockets
// (server_tcp_test.cc).

#include "playhouse/server/server.h"

#include <gtest/gtest.h>

#include "playhouse/server/fake_driver.h"
#include "playhouse/server/test_client.h"
#include "playhouse/wire/generated/common.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/messages.h"

namespace playhouse::server {
namespace {

namespace position2d = wire::position2d;
constexpr std::uint16_t kWheels = position2d::kCode, kLaser = wire::laser::kCode;
constexpr std::uint16_t kPort = 6665;

Bytes drive(double speed) {
  position2d::CmdVel command;
  command.vel.px = speed;
  return message(wire::MessageType::kCmd, kWheels, 0, position2d::kCmdVel, wire::encode(command));
}
Bytes request(std::uint16_t interf, std::uint8_t subtype, const Bytes& body = {}, std::uint32_t seq = 0) {
  return message(wire::MessageType::kReq, interf, 0, subtype, body, seq);
}
Bytes with_size(Bytes message, std::uint32_t size) {
  for (int i = 0; i < 4; ++i)
    message[36 + static_cast<std::size_t>(i)] = static_cast<std::byte>(size >> (24 - 8 * i));
  return message;
}

class ServerTest : public ::testing::Test {
 protected:
  ServerTest() {
    server.set_clock([this] { return now; });
    EXPECT_EQ(*server.listen(kPort), kPort);
    wheels_id = *server.add_device({kPort, kWheels, 0}, wheels);
    laser_id = *server.add_device({kPort, kLaser, 0}, laser);
    wheels.answers[position2d::kReqGetGeom] = wire::encode(position2d::Geom{});
    wheels.answers[position2d::kReqSetOdom] = {};
  }
  // Drivers let go of requests before the server ends.
  ~ServerTest() override {
    wheels.held.clear();
    wheels.barriers.clear();
  }

  void publish(device::DeviceId id, double time, std::size_t bytes = 52) {
    std::vector<device::Publication> batch;
    batch.push_back({id, 1, time, Bytes(bytes)});
    server.publish(std::move(batch));
  }

  net::SimulatedNetwork network{11};
  FakeDriver wheels{"stage"}, laser{"stage"};
  Server server{network};
  device::DeviceId wheels_id, laser_id;
  double now = 100.0;
};

TEST_F(ServerTest, greets_with_thirty_two_bytes_that_name_the_version) {
  TestClient client(network, kPort);
  ASSERT_EQ(client.banner.size(), 32u);
  EXPECT_EQ(client.banner.substr(0, 14), "Player v.3.1.1");
  EXPECT_EQ(client.banner.back(), '\0');
  EXPECT_TRUE(client.read().empty());
}

TEST_F(ServerTest, lists_the_devices_of_its_port_and_names_their_drivers) {
  ASSERT_EQ(*server.listen(6666), 6666);
  ASSERT_TRUE(server.add_device({6666, kWheels, 7}, laser));
  TestClient client(network, kPort);
  auto replies = client.ask(player_request(wire::player::kReqDevlist, {}, 4321));
  ASSERT_EQ(outline(replies), "ACK 1");
  EXPECT_EQ(replies[0].header.seq, 4321u);
  EXPECT_EQ(replies[0].header.host, wire::kLocalhost);
  EXPECT_EQ(replies[0].header.robot, kPort);
  EXPECT_EQ(replies[0].header.timestamp, 100.0);
  const auto list = wire::decode<wire::player::DeviceDevlist>(replies[0].body);
  const std::vector<wire::Devaddr> expected = {{wire::kLocalhost, kPort, kWheels, 0},
                                               {wire::kLocalhost, kPort, kLaser, 0}};
  EXPECT_EQ(list->devices, expected);
  replies = client.ask(player_request(wire::player::kReqDriverinfo,
                                      wire::encode(wire::player::DeviceDriverinfo{{0, 0, kLaser, 0}, ""})));
  ASSERT_EQ(outline(replies), "ACK 2");
  EXPECT_EQ(wire::decode<wire::player::DeviceDriverinfo>(replies[0].body)->driver_name,
            wire::c_string("stage"));
  replies = client.ask(player_request(wire::player::kReqDriverinfo,
                                      wire::encode(wire::player::DeviceDriverinfo{{0, 0, kWheels, 7}, ""})));
  ASSERT_EQ(outline(replies), "NACK 2");
  EXPECT_TRUE(replies[0].body.empty());
}

TEST_F(ServerTest, sends_data_to_the_clients_alone_that_they_are_for) {
  std::vector<std::uint32_t> serials;
  wheels.on_caller = [&](const device::Caller& caller) { serials.push_back(caller.serial()); };
  TestClient one(network, kPort), other(network, kPort), third(network, kPort);
  for (TestClient* client : {&one, &other, &third}) {
    ASSERT_EQ(outline(client->ask(open_request(kWheels, 0))), "ACK 3");
    ASSERT_EQ(outline(client->ask(request(kWheels, position2d::kReqGetGeom))), "ACK 1");
  }
  ASSERT_EQ(serials.size(), 3u);
  EXPECT_NE(serials[0], device::kDrivers);
  const auto publish_for = [&](double time, std::vector<std::uint32_t> clients) {
    server.publish({{wheels_id, 1, time, Bytes(52), std::move(clients)}});
  };
  publish_for(1, {serials[0], serials[1]});
  publish_for(2, {serials[1]});
  publish_for(3, {device::kDrivers});
  publish_for(4, {});
  const auto times = [](const std::vector<Received>& messages) {
    std::vector<double> times;
    for (const Received& message : messages) times.push_back(message.header.timestamp);
    return times;
  };
  EXPECT_EQ(times(one.read()), (std::vector<double>{1, 4}));
  EXPECT_EQ(times(other.read()), (std::vector<double>{1, 2, 4}));
  EXPECT_EQ(times(third.read()), (std::vector<double>{4}));
  EXPECT_EQ(server.status().messages_encoded, 3u) << "what is for nobody is not encoded";
}

TEST_F(ServerTest, lists_devices_that_came_after_the_first_list) {
  TestClient client(network, kPort);
  const auto count = [&] {
    const auto replies = client.ask(player_request(wire::player::kReqDevlist));
    return wire::decode<wire::player::DeviceDevlist>(replies.at(0).body)->devices.size();
  };
  EXPECT_EQ(count(), 2u);
  ASSERT_TRUE(server.add_device({kPort, kWheels, 1}, wheels));
  EXPECT_EQ(count(), 3u);
}

TEST_F(ServerTest, opens_sends_data_and_closes) {
  TestClient client(network, kPort);
  auto replies = client.ask(open_request(kWheels, 0));
  ASSERT_EQ(outline(replies), "ACK 3");
  EXPECT_EQ(access_of(replies[0]), 1);
  EXPECT_EQ(replies[0].body.size(), 36u);
  EXPECT_EQ(wheels.starts, 1);
  publish(wheels_id, 1.5);
  publish(laser_id, 1.5);
  replies = client.read();
  ASSERT_EQ(outline(replies), "DATA 1 of 4");
  EXPECT_EQ(replies[0].header.timestamp, 1.5);
  replies = client.ask(open_request(kWheels, 0, 2));
  EXPECT_EQ(access_of(replies[0]), 2);
  EXPECT_EQ(wheels.stops, 1);
  publish(wheels_id, 1.6);
  EXPECT_TRUE(client.read().empty());
}

TEST_F(ServerTest, answers_a_failed_open_as_the_protocol_says) {
  TestClient client(network, kPort);
  auto replies = client.ask(open_request(kWheels, 77));
  ASSERT_EQ(outline(replies), "NACK 3");
  EXPECT_EQ(replies[0].body.size(), 28u);
  EXPECT_EQ(access_of(replies[0]), 3);
  replies = client.ask(open_request(kWheels, 0, 7));
  ASSERT_EQ(outline(replies), "ACK 3");
  EXPECT_EQ(access_of(replies[0]), 3);
  wheels.fails_to_start = true;
  replies = client.ask(open_request(kWheels, 0));
  ASSERT_EQ(outline(replies), "ACK 3");
  EXPECT_EQ(access_of(replies[0]), 3);
  wheels.fails_to_start = false;
  EXPECT_EQ(access_of(client.ask(open_request(kWheels, 0))[0]), 1);
}

TEST_F(ServerTest, answers_an_open_once_the_device_is_prepared_and_lets_what_follows_wait) {
  wheels.unprepared = "lab:6665 is away";
  TestClient client(network, kPort);
  client.send(open_request(kWheels, 0));
  client.send(open_request(kLaser, 0));
  client.send(drive(1));
  std::vector<Received> answers = client.read();
  ASSERT_EQ(outline(answers), "ACK 3") << "of the laser";
  EXPECT_TRUE(wheels.commands.empty());
  wheels.prepare_now();
  answers = client.read();
  ASSERT_EQ(outline(answers), "ACK 3");
  EXPECT_EQ(access_of(answers[0]), 1);
  EXPECT_EQ(wheels.commands.size(), 1u);
  EXPECT_EQ(wheels.starts, 1);
}

TEST_F(ServerTest, answers_an_open_of_what_cannot_be_prepared_or_retires_meanwhile) {
  wheels.unprepared = "lab:6665 is away";
  TestClient client(network, kPort);
  client.ask(open_request(kWheels, 0));
  wheels.refuse_now();
  std::vector<Received> answers = client.read();
  ASSERT_EQ(outline(answers), "ACK 3");
  EXPECT_EQ(access_of(answers[0]), 3);
  client.ask(open_request(kWheels, 0));
  server.retire_device(wheels_id);
  answers = client.read();
  ASSERT_EQ(outline(answers), "NACK 3");
  EXPECT_EQ(access_of(answers[0]), 3);
  wheels.prepare_now();
  EXPECT_EQ(client.read().size(), 0u);
  EXPECT_EQ(wheels.starts, 0);
}

TEST_F(ServerTest, opens_nothing_for_a_client_that_left_while_it_was_prepared) {
  wheels.unprepared = "lab:6665 is away";
  TestClient client(network, kPort);
  client.ask(open_request(kWheels, 0));
  client.peer.reset();
  network.run_for(10);
  wheels.prepare_now();
  network.run();
  EXPECT_EQ(wheels.starts, 0);
  EXPECT_EQ(server.status().sessions, 0u);
}

TEST_F(ServerTest, does_not_let_a_stray_close_disturb_others) {
  TestClient reader(network, kPort), stray(network, kPort);
  reader.ask(open_request(kWheels, 0));
  const auto replies = stray.ask(open_request(kWheels, 0, 2));
  ASSERT_EQ(outline(replies), "ACK 3");
  EXPECT_EQ(access_of(replies[0]), 3);
  EXPECT_EQ(wheels.stops, 0);
  publish(wheels_id, 1);
  EXPECT_EQ(reader.read().size(), 1u);
}

TEST_F(ServerTest, delivers_once_however_often_a_device_is_opened_and_counts_closes) {
  TestClient client(network, kPort);
  client.ask(open_request(kWheels, 0));
  client.ask(open_request(kWheels, 0));
  publish(wheels_id, 1);
  EXPECT_EQ(client.read().size(), 1u);
  EXPECT_EQ(access_of(client.ask(open_request(kWheels, 0, 2))[0]), 2);
  publish(wheels_id, 2);
  EXPECT_EQ(client.read().size(), 1u);
  EXPECT_EQ(access_of(client.ask(open_request(kWheels, 0, 2))[0]), 2);
  EXPECT_EQ(access_of(client.ask(open_request(kWheels, 0, 2))[0]), 3);
  EXPECT_EQ(wheels.stops, 1);
}

TEST_F(ServerTest, takes_letters_for_access_and_answers_with_the_same_letter) {
  TestClient client(network, kPort);
  for (const char letter : {'r', 'w', 'a', 'c'}) {
    const auto replies = client.ask(open_request(kWheels, 0, static_cast<std::uint8_t>(letter)));
    ASSERT_EQ(outline(replies), "ACK 3");
    EXPECT_EQ(access_of(replies[0]), static_cast<std::uint8_t>(letter));
  }
}

TEST_F(ServerTest, lets_a_reader_look_but_not_touch) {
  TestClient client(network, kPort);
  client.ask(open_request(kWheels, 0, 'r'));
  client.ask(drive(1.0));
  EXPECT_TRUE(wheels.commands.empty());
  EXPECT_EQ(server.status().commands_dropped, 1u);
  EXPECT_EQ(outline(client.ask(request(kWheels, position2d::kReqGetGeom))), "ACK 1");
  EXPECT_EQ(outline(client.ask(request(kWheels, position2d::kReqSetOdom, Bytes(24)))), "NACK 5");
  EXPECT_EQ(outline(client.ask(request(kWheels, 255, wire::encode(wire::CapabilitiesReq{3, 1})))),
            "NACK 255");
  publish(wheels_id, 1);
  EXPECT_EQ(client.read().size(), 1u);
  client.ask(open_request(kWheels, 0));  // the last open counts
  client.ask(drive(1.0));
  EXPECT_EQ(wheels.commands.size(), 1u);
}

TEST_F(ServerTest, sends_no_data_to_a_writer) {
  TestClient client(network, kPort);
  client.ask(open_request(kWheels, 0, 'w'));
  publish(wheels_id, 1);
  EXPECT_TRUE(client.read().empty());
  client.ask(drive(1.0));
  EXPECT_EQ(wheels.commands.size(), 1u);
}

TEST_F(ServerTest, lets_a_session_command_that_opened_nothing_and_never_locks_a_second_one_out) {
  TestClient first(network, kPort), second(network, kPort);
  first.ask(open_request(kWheels, 0));
  first.ask(drive(0.25));
  second.ask(drive(0.5));
  ASSERT_EQ(wheels.commands.size(), 2u);
  EXPECT_EQ(wire::decode<position2d::CmdVel>(wheels.commands[1].second)->vel.px, 0.5);
  EXPECT_EQ(outline(second.ask(request(kWheels, position2d::kReqGetGeom, {}, 17))), "ACK 1");
}

TEST_F(ServerTest, answers_nack_to_every_request_that_cannot_be_served) {
  TestClient client(network, kPort);
  const auto nack = [&](const Bytes& bytes) {
    const auto replies = client.ask(bytes);
    return replies.size() == 1 && replies[0].header.type == wire::MessageType::kNack &&
           replies[0].header.seq == 5;
  };
  EXPECT_TRUE(nack(message(wire::MessageType::kReq, kWheels, 77, 1, {}, 5)));   // no such device
  EXPECT_TRUE(nack(request(500, 1, {}, 5)));                                    // no such interface
  EXPECT_TRUE(nack(request(kWheels, 200, {}, 5)));                              // no such request
  EXPECT_TRUE(nack(request(kWheels, 200, Bytes(4), 5)));                        // the same with a body
  EXPECT_TRUE(nack(request(kWheels, position2d::kReqSetOdom, Bytes(4), 5)));    // too short
  EXPECT_TRUE(nack(request(kWheels, position2d::kReqSpeedPid, Bytes(12), 5)));  // the driver does not know it
  EXPECT_TRUE(nack(player_request(99, {}, 5)));
  EXPECT_TRUE(nack(player_request(99, Bytes(8), 5)));
  EXPECT_TRUE(nack(player_request(wire::player::kReqAuth, Bytes(8), 5)));
  EXPECT_TRUE(nack(player_request(wire::player::kReqNameservice, Bytes(12), 5)));
  EXPECT_TRUE(nack(player_request(wire::player::kReqDev, Bytes(3), 5)));
  EXPECT_TRUE(nack(message(wire::MessageType::kCmd, wire::player::kCode, 0, 3, {}, 5)));
  EXPECT_EQ(server.status().sessions, 1u);
}

/// Bytes of the shortest body that decodes: zeros, so every array is empty.
std::size_t shortest_body(const wire::MessageDef& def) {
  std::size_t size = 4;
  while (!def.check(Bytes(size)).empty()) size += 4;
  return size;
}

TEST_F(ServerTest, lets_no_body_of_a_wrong_size_through_to_any_driver_of_any_interface) {
  constexpr std::uint16_t kIndex = 9;
  FakeDriver driver;
  TestClient client(network, kPort);
  std::size_t messages = 0;
  // What the driver got and what the client heard, for a body of zeros or of ones.
  const auto send = [&](const wire::MessageDef& def, std::uint16_t interf, const Bytes& body) {
    const std::size_t before = driver.commands.size() + static_cast<std::size_t>(driver.requests);
    const auto replies = client.ask(message(def.type, interf, kIndex, def.subtype, body, 5));
    if (def.type == wire::MessageType::kReq) {
      EXPECT_EQ(outline(replies), "NACK " + std::to_string(def.subtype)) << def.name << " " << body.size();
    } else {
      EXPECT_TRUE(replies.empty()) << def.name << " " << body.size();
    }
    return driver.commands.size() + static_cast<std::size_t>(driver.requests) > before;
  };
  for (const wire::InterfaceDef& interf : wire::interfaces()) {
    if (interf.code == wire::player::kCode) continue;
    ASSERT_TRUE(server.add_device({kPort, interf.code, kIndex}, driver));
    for (const wire::MessageDef& def : interf.messages) {
      if (!def.has_payload || def.type == wire::MessageType::kData) continue;
      ++messages;
      const std::size_t size = shortest_body(def);
      EXPECT_EQ(send(def, interf.code, {}), def.type == wire::MessageType::kReq) << def.name;
      for (const std::size_t wrong : {std::size_t{1}, std::max(size - 4, std::size_t{2}), size - 1})
        EXPECT_FALSE(send(def, interf.code, Bytes(wrong))) << def.name << " " << wrong;
      EXPECT_TRUE(send(def, interf.code, Bytes(size))) << def.name;
      EXPECT_TRUE(send(def, interf.code, Bytes(size + 5))) << def.name;
      const Bytes ones(size + 8, std::byte{0xff});  // every count is 4294967295
      EXPECT_EQ(send(def, interf.code, ones), def.check(ones).empty()) << def.name;
    }
    for (const wire::MessageType type : {wire::MessageType::kData, wire::MessageType::kAck,
                                         wire::MessageType::kNack, wire::MessageType::kSynch}) {
      EXPECT_TRUE(client.ask(message(type, interf.code, kIndex, 1, Bytes(100))).empty());
    }
  }
  EXPECT_GT(messages, 100u);
  EXPECT_EQ(server.status().sessions, 1u);
}

TEST_F(ServerTest, drops_commands_that_cannot_be_carried_out_and_counts_them) {
  TestClient client(network, kPort);
  wheels.ignored_command = position2d::kCmdCar;
  client.ask(message(wire::MessageType::kCmd, kWheels, 9, position2d::kCmdVel, Bytes(28)));
  client.ask(message(wire::MessageType::kCmd, kWheels, 0, 99, Bytes(28)));
  client.ask(message(wire::MessageType::kCmd, kWheels, 0, position2d::kCmdVel, Bytes(12)));
  client.ask(message(wire::MessageType::kCmd, kWheels, 0, position2d::kCmdVel));
  client.ask(message(wire::MessageType::kCmd, kWheels, 0, position2d::kCmdCar, Bytes(16)));
  client.ask(message(wire::MessageType::kData, kWheels, 0, 1, Bytes(52)));
  EXPECT_TRUE(client.ask(message(wire::MessageType{255}, kWheels, 0, 1)).empty());
  EXPECT_TRUE(wheels.commands.empty());
  EXPECT_EQ(server.status().commands_dropped, 7u);
  EXPECT_EQ(outline(client.ask(request(kWheels, position2d::kReqGetGeom))), "ACK 1");
}

TEST_F(ServerTest, asks_the_driver_what_it_is_capable_of) {
  TestClient client(network, kPort);
  const Bytes ask_capability = wire::encode(wire::CapabilitiesReq{3, 1});
  EXPECT_EQ(outline(client.ask(request(kWheels, wire::kReqCapabilities, ask_capability))), "NACK 255");
  wheels.capable_of_all = true;
  EXPECT_EQ(outline(client.ask(request(kWheels, wire::kReqCapabilities, ask_capability))), "ACK 255");
}

TEST_F(ServerTest, asks_the_driver_for_properties_and_lets_a_reader_only_look) {
  const Bytes skip = wire::encode(wire::IntpropReq{wire::c_string("skip"), 7});
  wheels.answers[wire::kReqGetIntprop] = skip;
  wheels.answers[wire::kReqSetIntprop] = {};
  TestClient client(network, kPort);
  const auto replies = client.ask(request(kWheels, wire::kReqGetIntprop, skip));
  ASSERT_EQ(outline(replies), "ACK 254");
  EXPECT_EQ(wire::decode<wire::IntpropReq>(replies[0].body)->value, 7);
  EXPECT_EQ(outline(client.ask(request(kWheels, wire::kReqSetIntprop, skip))), "ACK 253");
  EXPECT_EQ(wheels.requests, 2);

  client.ask(open_request(kWheels, 0, 'r'));
  EXPECT_EQ(outline(client.ask(request(kWheels, wire::kReqSetIntprop, skip))), "NACK 253");
  EXPECT_EQ(wheels.requests, 2);
  EXPECT_EQ(outline(client.ask(request(kWheels, wire::kReqGetIntprop, skip))), "ACK 254");
}

TEST_F(ServerTest, goes_by_the_last_access_of_a_device_opened_twice_until_both_are_closed) {
  TestClient client(network, kPort);
  client.ask(mode_request(2));
  client.ask(open_request(kWheels, 0));
  publish(wheels_id, 1);
  EXPECT_EQ(outline(client.ask(open_request(kWheels, 0, 'w'))), "ACK 3") << "a writer's data is taken out";
  publish(wheels_id, 2);
  EXPECT_EQ(outline(client.ask(drive(1.0))), "");
  EXPECT_EQ(wheels.commands.size(), 1u);

  client.ask(open_request(kWheels, 0, 'r'));
  client.ask(drive(2.0));
  EXPECT_EQ(wheels.commands.size(), 1u);
  publish(wheels_id, 3);
  EXPECT_EQ(outline(client.ask(player_request(wire::player::kReqData))), "ACK 4, DATA 1 of 4, SYNCH 1");

  client.ask(open_request(kWheels, 0, 2));
  client.ask(open_request(kWheels, 0, 'c'));
  client.ask(drive(2.0));
  EXPECT_EQ(wheels.commands.size(), 1u) << "open once more, and for reading as before";
  EXPECT_EQ(wheels.stops, 0);
  client.ask(open_request(kWheels, 0, 2));
  EXPECT_EQ(wheels.starts, 1);
  EXPECT_EQ(wheels.stops, 1);
  client.ask(drive(2.0));
  EXPECT_EQ(wheels.commands.size(), 2u) << "who has nothing open may command";
}

TEST_F(ServerTest, answers_later_when_the_driver_does_and_nobody_when_the_client_is_gone) {
  wheels.holds_requests = true;
  TestClient client(network, kPort), leaver(network, kPort);
  EXPECT_TRUE(client.ask(request(kWheels, position2d::kReqGetGeom, {}, 1)).empty());
  EXPECT_TRUE(client.ask(request(kWheels, position2d::kReqGetGeom, {}, 2)).empty());
  leaver.ask(request(kWheels, position2d::kReqGetGeom, {}, 3));
  leaver.peer.vanish();
  network.run();
  ASSERT_EQ(wheels.held.size(), 3u);
  wheels.held[2].ack();
  wheels.held[1].ack(Bytes(72));
  wheels.held.clear();  // the first is dropped unanswered
  const auto replies = client.read();
  ASSERT_EQ(outline(replies), "ACK 1, NACK 1");
  EXPECT_EQ(replies[0].header.seq, 2u);
  EXPECT_EQ(replies[1].header.seq, 1u);
}

TEST_F(ServerTest, speaks_pull_as_the_c_library_does) {
  TestClient client(network, kPort);
  client.ask(mode_request(2));
  client.ask(open_request(kWheels, 0));
  publish(wheels_id, 1);
  publish(wheels_id, 2);
  EXPECT_TRUE(client.read().empty());
  EXPECT_EQ(outline(client.ask(player_request(wire::player::kReqData))),
            "ACK 4, DATA 1 of 4, DATA 1 of 4, SYNCH 1");
  EXPECT_EQ(outline(client.ask(player_request(wire::player::kReqData))), "ACK 4");
  publish(wheels_id, 3);
  EXPECT_EQ(outline(client.read()), "DATA 1 of 4, SYNCH 1");
  client.ask(rule_request(-1, 1, 1));
  publish(wheels_id, 4);
  publish(wheels_id, 5);
  const auto round = client.ask(player_request(wire::player::kReqData));
  ASSERT_EQ(outline(round), "ACK 4, DATA 1 of 4, SYNCH 1");
  EXPECT_EQ(round[1].header.timestamp, 5.0);
  EXPECT_EQ(outline(client.ask(mode_request(9))), "ACK 5");
  publish(wheels_id, 6);
  EXPECT_TRUE(client.read().empty());
  EXPECT_EQ(outline(client.ask(mode_request(1))), "DATA 1 of 4, ACK 5");
}

TEST_F(ServerTest, purges_the_data_of_a_closed_device) {
  TestClient client(network, kPort);
  client.ask(mode_request(2));
  client.ask(open_request(kWheels, 0));
  publish(wheels_id, 1);
  EXPECT_EQ(outline(client.ask(open_request(kWheels, 0, 2))), "ACK 3");
}

TEST_F(ServerTest, raises_timestamps_that_repeat) {
  TestClient client(network, kPort);
  client.ask(open_request(kWheels, 0));
  for (const double time : {5.0, 5.0, 5.0, 6.0}) publish(wheels_id, time);
  const auto data = client.read();
  ASSERT_EQ(data.size(), 4u);
  for (std::size_t i = 1; i < data.size(); ++i)
    EXPECT_GT(data[i].header.timestamp, data[i - 1].header.timestamp);
  EXPECT_EQ(data[3].header.timestamp, 6.0);
}

TEST_F(ServerTest, lets_timestamps_go_back_with_the_time_of_the_run) {
  TestClient client(network, kPort);
  client.ask(open_request(kWheels, 0));
  for (const double time : {5.0, 5.0, 4.0, 4.0, 4.5}) publish(wheels_id, time);
  const auto data = client.read();
  ASSERT_EQ(data.size(), 5u);
  EXPECT_EQ(data[2].header.timestamp, 4.0);
  EXPECT_GT(data[3].header.timestamp, 4.0);
  EXPECT_EQ(data[4].header.timestamp, 4.5);
}

TEST_F(ServerTest, encodes_a_message_once_for_all_its_readers) {
  std::vector<TestClient> clients;
  for (int i = 0; i < 20; ++i) clients.emplace_back(network, kPort).ask(open_request(kWheels, 0));
  publish(wheels_id, 1);
  for (TestClient& client : clients) EXPECT_EQ(client.read().size(), 1u);
  EXPECT_EQ(server.status().messages_encoded, 1u);
  EXPECT_EQ(server.status().messages_sent, 40u);
}

TEST_F(ServerTest, carries_out_what_was_sent_before_the_end) {
  TestClient client(network, kPort);
  client.ask(open_request(kWheels, 0));
  client.send(drive(0.5));
  client.send(drive(0.0));
  client.peer.finish();
  network.run();
  ASSERT_EQ(wheels.commands.size(), 2u);
  EXPECT_EQ(wire::decode<position2d::CmdVel>(wheels.commands[1].second)->vel.px, 0.0);
  EXPECT_EQ(wheels.stops, 1);
  EXPECT_EQ(server.status().sessions, 0u);
}

TEST_F(ServerTest, still_answers_a_client_that_has_finished_sending) {
  TestClient client(network, kPort);
  client.send(request(kWheels, position2d::kReqGetGeom));
  client.peer.finish();
  EXPECT_EQ(outline(client.read()), "ACK 1");
  EXPECT_TRUE(client.peer.closed());
}

TEST_F(ServerTest, waits_for_drivers_to_answer_a_client_that_has_finished_sending) {
  wheels.holds_requests = true;
  TestClient client(network, kPort);
  client.send(open_request(kWheels, 0));
  client.send(request(kWheels, position2d::kReqGetGeom, {}, 7));
  client.peer.finish();
  EXPECT_EQ(outline(client.read()), "ACK 3");
  EXPECT_EQ(wheels.stops, 1) << "a robot does not run for a client that has gone";
  EXPECT_FALSE(client.peer.closed());
  wheels.held[0].ack(Bytes(72));
  EXPECT_EQ(outline(client.read()), "ACK 1");
  EXPECT_TRUE(client.peer.closed());
  EXPECT_EQ(server.status().sessions, 0u);
}

TEST_F(ServerTest, does_not_wait_for_ever_for_an_answer_to_a_client_that_has_finished_sending) {
  wheels.holds_requests = true;
  TestClient client(network, kPort);
  client.send(request(kWheels, position2d::kReqGetGeom));
  client.peer.finish();
  network.run_for(60);
  EXPECT_TRUE(client.peer.closed());
  wheels.held[0].ack();
  network.run();
  EXPECT_EQ(server.status().sessions, 0u);
}

TEST_F(ServerTest, closes_the_devices_of_a_client_that_vanishes) {
  TestClient client(network, kPort), other(network, kPort);
  client.ask(open_request(kWheels, 0));
  other.ask(open_request(kLaser, 0));
  client.peer.vanish();
  network.run();
  EXPECT_EQ(wheels.stops, 1);
  EXPECT_EQ(laser.stops, 0);
  EXPECT_FALSE(server.has_readers(wheels_id));
}

TEST_F(ServerTest, closes_only_the_session_whose_frame_cannot_be) {
  TestClient good(network, kPort);
  for (const std::uint32_t size :
       {0x7fffffffu, 0x80000000u, 0xffffffd8u, 0xffffffffu, 0xfffffff0u, 0x2000000u}) {
    TestClient bad(network, kPort);
    bad.send(drive(1.0));
    bad.send(with_size(drive(2.0), size));
    network.run();
    EXPECT_TRUE(bad.peer.closed()) << size;
    EXPECT_EQ(wheels.commands.size(), 1u);  // what came before it counts
    wheels.commands.clear();
  }
  EXPECT_EQ(server.status().sessions_broken, 6u);
  EXPECT_EQ(outline(good.ask(player_request(wire::player::kReqDevlist))), "ACK 1");
}

TEST_F(ServerTest, waits_for_a_large_body_and_ignores_bytes_after_a_value) {
  TestClient client(network, kPort);
  network.piece_bytes = 65536;
  Bytes command = wire::encode(position2d::CmdVel{});
  command.resize(3u << 20);
  client.ask(message(wire::MessageType::kCmd, kWheels, 0, position2d::kCmdVel, command));
  EXPECT_EQ(wheels.commands.size(), 1u);
}

TEST_F(ServerTest, takes_messages_byte_by_byte_and_ignores_high_bits_of_small_fields) {
  network.piece_bytes = 1;
  TestClient client(network, kPort);
  Bytes odd = request(kWheels, position2d::kReqGetGeom);
  odd[8] = odd[12] = odd[16] = odd[20] = std::byte{0xAB};
  client.send(odd);
  client.send(player_request(wire::player::kReqDevlist));
  EXPECT_EQ(outline(client.read()), "ACK 1, ACK 1");
}

TEST_F(ServerTest, bounds_what_waits_for_a_stalled_client_and_serves_the_others) {
  network.window_bytes = 4096;
  TestClient stalled(network, kPort), good(network, kPort);
  stalled.ask(open_request(kWheels, 0));
  good.ask(open_request(kWheels, 0));
  stalled.peer.stall();
  std::size_t received = 0;
  for (int i = 0; i < 3000; ++i) {
    publish(wheels_id, i);
    received += good.read().size();
  }
  EXPECT_EQ(received, 3000u);
  const ServerStatus status = server.status();
  EXPECT_EQ(status.stalled_sessions, 1u);
  EXPECT_GT(status.data_dropped, 1500u);
  stalled.peer.read_on();
  const auto late = stalled.read();
  EXPECT_EQ(late.size() + status.data_dropped, 3000u);
  EXPECT_EQ(late.back().header.timestamp, 2999.0);
  EXPECT_EQ(server.status().stalled_sessions, 0u);
}

/// How many data messages the server says that a client lost.
std::int32_t told_lost(TestClient& client) {
  const auto replies = client.ask(
      player_request(wire::kReqGetIntprop, wire::encode(wire::IntpropReq{wire::c_string("lost"), 0})));
  if (outline(replies) != "ACK 254") return -1;
  return wire::decode<wire::IntpropReq>(replies[0].body)->value;
}

TEST_F(ServerTest, tells_a_client_how_many_messages_it_lost_and_nothing_of_other_properties) {
  network.window_bytes = 4096;
  TestClient stalled(network, kPort), good(network, kPort);
  stalled.ask(open_request(kWheels, 0));
  EXPECT_EQ(told_lost(stalled), 0);
  stalled.peer.stall();
  for (int i = 0; i < 3000; ++i) {
    publish(wheels_id, i);
    network.run();
  }
  stalled.peer.read_on();
  const std::size_t late = stalled.read().size();
  EXPECT_EQ(told_lost(stalled), static_cast<std::int32_t>(3000 - late));
  EXPECT_EQ(told_lost(good), 0);
  EXPECT_EQ(outline(good.ask(player_request(wire::kReqGetIntprop,
                                            wire::encode(wire::IntpropReq{wire::c_string("other"), 0})))),
            "NACK 254");
}

TEST_F(ServerTest, tells_every_reader_of_what_gave_way_before_it_came_to_the_queues) {
  TestClient reader(network, kPort), other(network, kPort);
  reader.ask(open_request(kWheels, 0));
  other.ask(open_request(kLaser, 0));
  for (int i = 0; i < 3; ++i)
    server.publish({{wheels_id, 1, static_cast<double>(i), Bytes(limits::kOutboxBytes / 2)}});
  network.run();
  EXPECT_GT(told_lost(reader), 0);
  EXPECT_EQ(told_lost(other), 0);
}

Bytes auth_request(std::string_view token) {
  wire::player::DeviceAuthReq key;
  key.auth_key.assign(token.begin(), token.end());
  return player_request(wire::player::kReqAuth, wire::encode(key));
}

/// Tokens by what they open: "watch", "drive" and "manage"; whoever has none may do what `open` says.
class GuestServerTest : public ServerTest {
 protected:
  void admit(std::optional<device::Rights> open) {
    server.admit_by([open](const std::string& token, const std::string&) -> std::optional<device::Rights> {
      if (token == "*") return open;
      if (token == "watch") return device::Rights{.drives = false, .manages = false};
      if (token == "drive") return device::Rights{.manages = false};
      if (token == "manage") return device::Rights{};
      return std::nullopt;
    });
  }
  std::string ask_geometry(TestClient& client) {
    return outline(client.ask(message(wire::MessageType::kReq, kWheels, 0, position2d::kReqGetGeom)));
  }
  std::string ask_reset(TestClient& client) {
    return outline(client.ask(message(wire::MessageType::kReq, kWheels, 0, position2d::kReqResetOdom)));
  }
};

TEST_F(GuestServerTest, who_has_no_token_is_closed_after_a_while_whatever_it_says) {
  admit(std::nullopt);
  TestClient stranger(network, kPort), guest(network, kPort);
  EXPECT_EQ(outline(stranger.ask(player_request(wire::player::kReqDevlist))), "NACK 1");
  EXPECT_EQ(outline(guest.ask(auth_request("watch"))), "ACK 7");
  network.run_for(limits::kSilentSeconds - 5);
  EXPECT_EQ(outline(stranger.ask(auth_request("wrong"))), "NACK 7");
  network.run_for(10);
  EXPECT_TRUE(stranger.peer.closed());
  network.run_for(10 * limits::kSilentSeconds);
  EXPECT_FALSE(guest.peer.closed());
}

TEST_F(GuestServerTest, strangers_make_room_for_guests_when_there_are_too_many) {
  admit(std::nullopt);
  std::vector<net::SimulatedPeer> strangers;
  for (std::size_t i = 0; i < limits::kSessions; ++i) {
    strangers.push_back(network.connect(kPort));
    strangers.back().send(player_request(wire::player::kReqDevlist));
  }
  network.run();
  TestClient guest(network, kPort);
  EXPECT_EQ(outline(guest.ask(auth_request("watch"))), "ACK 7");
  EXPECT_TRUE(strangers.front().closed());
}

TEST_F(GuestServerTest, who_has_no_token_gets_nothing) {
  admit(std::nullopt);
  TestClient client(network, kPort);
  EXPECT_EQ(outline(client.ask(player_request(wire::player::kReqDevlist))), "NACK 1");
  EXPECT_EQ(outline(client.ask(open_request(kWheels, 0))), "NACK 3");
  EXPECT_EQ(ask_geometry(client).substr(0, 4), "NACK");
  client.ask(drive(0.5));
  EXPECT_TRUE(wheels.commands.empty());
  EXPECT_EQ(wheels.requests, 0);
  EXPECT_EQ(outline(client.ask(auth_request("wrong"))), "NACK 7");
  EXPECT_EQ(outline(client.ask(player_request(wire::player::kReqDevlist))), "NACK 1");
}

TEST_F(GuestServerTest, a_token_opens_what_its_guest_may) {
  admit(std::nullopt);
  TestClient watcher(network, kPort), driver(network, kPort);
  EXPECT_EQ(outline(watcher.ask(auth_request("watch"))), "ACK 7");
  EXPECT_EQ(outline(watcher.ask(open_request(kWheels, 0))), "ACK 3");
  watcher.ask(drive(0.5));
  EXPECT_TRUE(wheels.commands.empty());
  ask_geometry(watcher);
  EXPECT_EQ(wheels.requests, 1);
  EXPECT_EQ(ask_reset(watcher).substr(0, 4), "NACK");
  EXPECT_EQ(wheels.requests, 1) << "of which the driver never heard";
  EXPECT_EQ(outline(driver.ask(auth_request("drive"))), "ACK 7");
  device::Rights seen;
  wheels.on_caller = [&](const device::Caller& caller) { seen = caller.rights(); };
  driver.ask(drive(0.5));
  EXPECT_EQ(wheels.commands.size(), 1u);
  ask_geometry(driver);
  EXPECT_TRUE(seen.drives);
  EXPECT_FALSE(seen.manages);
}

TEST_F(GuestServerTest, a_client_of_2005_may_what_guests_without_a_token_may) {
  admit(device::Rights{.drives = false, .manages = false});
  TestClient client(network, kPort);
  EXPECT_EQ(outline(client.ask(open_request(kWheels, 0))), "ACK 3");
  client.ask(drive(0.5));
  EXPECT_TRUE(wheels.commands.empty());
  EXPECT_EQ(outline(client.ask(auth_request("drive"))), "ACK 7");
  client.ask(drive(0.5));
  EXPECT_EQ(wheels.commands.size(), 1u);
}

/// Lets one client act.
class OneTurn final : public device::Turns {
 public:
  bool may_act(const device::Caller& caller) const override { return caller.name() == whose; }
  void when_changed(std::function<void()> changed) override { changed_ = std::move(changed); }
  void give_to(std::string name) {
    whose = std::move(name);
    changed_();
  }

  std::string whose;

 private:
  std::function<void()> changed_;
};

TEST_F(ServerTest, what_clients_change_waits_for_their_turn_and_what_they_only_ask_does_not) {
  OneTurn turns;
  server.take_turns(turns);
  TestClient client(network, kPort);
  EXPECT_EQ(outline(client.ask(open_request(kWheels, 0))), "ACK 3");
  client.ask(drive(0.5));
  EXPECT_TRUE(wheels.commands.empty());
  EXPECT_EQ(outline(client.ask(player_request(wire::player::kReqDevlist))), "")
      << "it waits behind the command";
  std::string name;
  wheels.on_caller = [&](const device::Caller& caller) { name = caller.name(); };
  TestClient asking(network, kPort);
  EXPECT_EQ(outline(asking.ask(player_request(wire::player::kReqDevlist))), "ACK 1");
  asking.ask(message(wire::MessageType::kReq, kWheels, 0, position2d::kReqGetGeom));
  EXPECT_EQ(wheels.requests, 1) << "a question";
  EXPECT_NE(name, "");
}

TEST_F(ServerTest, what_waited_for_its_turn_is_carried_out_when_that_comes) {
  OneTurn turns;
  server.take_turns(turns);
  TestClient client(network, kPort);
  client.ask(open_request(kWheels, 0));
  std::string name;
  wheels.on_caller = [&](const device::Caller& caller) { name = caller.name(); };
  client.ask(message(wire::MessageType::kReq, kWheels, 0, position2d::kReqGetGeom));
  client.ask(drive(0.5));
  EXPECT_TRUE(wheels.commands.empty());
  turns.give_to(name);
  network.run();
  EXPECT_EQ(wheels.commands.size(), 1u);
}

TEST_F(ServerTest, stops_reading_from_a_client_that_asks_without_reading) {
  network.window_bytes = 4096;
  TestClient flooder(network, kPort), good(network, kPort);
  flooder.peer.stall();
  constexpr int kRequests = 20000;
  for (int i = 0; i < kRequests; ++i) flooder.send(request(kWheels, position2d::kReqGetGeom));
  network.run();
  EXPECT_LT(wheels.requests, 10000);
  EXPECT_EQ(outline(good.ask(request(kWheels, position2d::kReqGetGeom))), "ACK 1");
  flooder.peer.read_on();
  EXPECT_EQ(flooder.read().size(), static_cast<std::size_t>(kRequests));
}

TEST_F(ServerTest, goes_on_with_a_client_whose_answers_come_late_or_are_not_wanted) {
  TestClient client(network, kPort);
  wheels.holds_requests = true;
  client.ask(rule_request(-1, -1, 2));
  for (std::size_t i = 0; i < limits::kSessionAnswers + 10; ++i)
    client.send(request(kWheels, position2d::kReqGetGeom));
  network.run();
  EXPECT_EQ(wheels.held.size(), limits::kSessionAnswers);
  wheels.held.clear();
  network.run();
  EXPECT_EQ(wheels.held.size(), 10u);
}

TEST_F(ServerTest, answers_every_request_of_a_client_that_sends_more_in_one_piece_than_it_may_be_owed) {
  network.piece_bytes = 1u << 30;
  TestClient client(network, kPort);
  constexpr std::size_t kRequests = 3 * limits::kSessionAnswers + 1;
  for (std::size_t i = 0; i < kRequests; ++i) client.send(request(kWheels, position2d::kReqGetGeom));
  EXPECT_EQ(client.read().size(), kRequests);
}

TEST_F(ServerTest, does_not_hurry_for_a_client_that_changed_things_without_end_and_was_reset) {
  wheels.holds_requests = true;
  TestClient flooder(network, kPort);
  constexpr std::size_t kRequests = 5 * limits::kSessionAnswers;
  for (std::size_t i = 0; i < kRequests; ++i)
    flooder.send(request(kWheels, position2d::kReqSetOdom, Bytes(24)));
  flooder.send(drive(0.5));
  flooder.peer.reset();
  network.run();
  EXPECT_EQ(wheels.held.size(), limits::kSessionAnswers);
  while (!wheels.held.empty()) {
    wheels.held.clear();
    network.run();
  }
  EXPECT_EQ(static_cast<std::size_t>(wheels.requests), kRequests);
  EXPECT_EQ(wheels.commands.size(), 1u) << "what was sent before the end is carried out";
  EXPECT_EQ(server.status().sessions, 0u);
}

TEST_F(ServerTest, asks_nothing_for_a_client_that_was_reset_and_still_does_what_it_said) {
  network.piece_bytes = 1u << 30;
  TestClient flooder(network, kPort);
  for (int i = 0; i < 5000; ++i) {
    flooder.send(player_request(wire::player::kReqDevlist));
    flooder.send(request(kWheels, position2d::kReqGetGeom));
  }
  flooder.send(open_request(kWheels, 0));
  flooder.send(drive(0.5));
  flooder.send(request(kWheels, position2d::kReqSetOdom, Bytes(24)));
  flooder.peer.reset();
  network.run();
  EXPECT_EQ(server.status().messages_received, 3u);
  EXPECT_EQ(server.status().messages_sent, 0u);
  EXPECT_EQ(wheels.commands.size(), 1u);
  EXPECT_EQ(wheels.requests, 1);
  EXPECT_EQ(wheels.stops, 1) << "its robot stops";
  EXPECT_EQ(server.status().sessions, 0u);
}

TEST_F(ServerTest, drops_what_it_owes_a_client_that_is_reset_while_it_does_not_read) {
  network.window_bytes = 4096;
  TestClient flooder(network, kPort);
  flooder.peer.stall();
  for (int i = 0; i < 20000; ++i) flooder.send(request(kWheels, position2d::kReqGetGeom));
  network.run();
  const int before = wheels.requests;
  flooder.peer.reset();
  network.run();
  EXPECT_EQ(wheels.requests, before);
  EXPECT_EQ(server.status().sessions, 0u);
}

TEST_F(ServerTest, gives_every_answer_to_a_client_that_asked_much_and_finished_sending) {
  network.window_bytes = 4096;
  TestClient client(network, kPort);
  constexpr std::size_t kRequests = 5 * limits::kSessionAnswers;
  for (std::size_t i = 0; i < kRequests; ++i) client.send(request(kWheels, position2d::kReqGetGeom));
  client.peer.finish();
  EXPECT_EQ(client.read().size(), kRequests);
  EXPECT_TRUE(client.peer.closed());
}

TEST_F(ServerTest, waits_five_seconds_for_a_client_that_finished_sending_and_does_not_read) {
  network.window_bytes = 4096;
  TestClient client(network, kPort);
  client.peer.stall();
  for (int i = 0; i < 100; ++i) client.send(request(kWheels, position2d::kReqGetGeom));
  client.peer.finish();
  network.run_for(4);
  EXPECT_EQ(server.status().sessions, 1u);
  network.run_for(2);
  EXPECT_EQ(server.status().sessions, 0u);
}

TEST_F(ServerTest, looks_only_at_the_clients_that_have_something_to_do) {
  std::vector<std::unique_ptr<TestClient>> idle;
  for (int i = 0; i < 500; ++i) idle.push_back(std::make_unique<TestClient>(network, kPort));
  TestClient client(network, kPort), reader(network, kPort);
  reader.ask(open_request(kLaser, 0));
  const std::uint64_t before = server.status().turns;
  constexpr int kRequests = 100;
  for (int i = 0; i < kRequests; ++i) {
    EXPECT_EQ(client.ask(request(kWheels, position2d::kReqGetGeom)).size(), 1u);
    publish(laser_id, i);
    EXPECT_EQ(reader.read().size(), 1u);
  }
  EXPECT_LE(server.status().turns - before, 4u * kRequests);  // a turn to send, and one when it is sent
}

TEST_F(ServerTest, serves_others_between_the_portions_of_one_that_asks_for_much) {
  network.piece_bytes = 1u << 30;
  laser.answers[wire::laser::kReqGetGeom] = Bytes(72);
  int served_before = -1;
  laser.on_request = [&] { served_before = wheels.requests; };
  TestClient greedy(network, kPort), modest(network, kPort);
  for (int i = 0; i < 1000; ++i) greedy.send(request(kWheels, position2d::kReqGetGeom));
  modest.send(request(kLaser, wire::laser::kReqGetGeom));
  network.run();
  EXPECT_EQ(wheels.requests, 1000);
  EXPECT_LE(served_before, static_cast<int>(limits::kTurnMessages));
}

// What drivers have published is shared out once per turn, not once per client of a turn, and counts per
// reader.
TEST_F(ServerTest, looks_at_the_sockets_again_after_one_portion_of_deliveries) {
  network.piece_bytes = 1u << 30;
  constexpr std::size_t kReaders = 32, kPublished = 4096;
  std::vector<std::unique_ptr<TestClient>> readers;
  for (std::size_t i = 0; i < kReaders; ++i) {
    readers.push_back(std::make_unique<TestClient>(network, kPort));
    readers.back()->ask(open_request(kLaser, 0));
    readers.back()->ask(open_request(kWheels, 0));
  }
  const std::uint64_t before = server.status().messages_encoded;
  std::vector<std::uint64_t> encoded;  // as each request is executed
  wheels.on_request = [&] { encoded.push_back(server.status().messages_encoded - before); };
  for (std::size_t i = 0; i < kPublished; ++i) publish(laser_id, static_cast<double>(i));
  for (const auto& reader : readers) reader->send(request(kWheels, position2d::kReqGetGeom));
  network.run();
  ASSERT_EQ(encoded.size(), kReaders);
  // As many turns may have passed as it takes for the requests to arrive: one portion of publications each.
  EXPECT_LE(encoded.back() - encoded.front(), 2 * limits::kTurnDeliveries / kReaders);
  EXPECT_EQ(server.status().messages_encoded - before, kPublished);
}

TEST_F(ServerTest, serves_others_while_one_asks_for_answers_that_it_has_left_out) {
  network.piece_bytes = 65536;
  laser.answers[wire::laser::kReqGetGeom] = Bytes(72);
  TestClient greedy(network, kPort), modest(network, kPort);
  EXPECT_TRUE(greedy.ask(rule_request(-1, static_cast<int>(wire::MessageType::kAck), 2)).empty());
  const std::uint64_t before = server.status().messages_received;
  std::uint64_t served_before = 0;
  laser.on_request = [&] { served_before = server.status().messages_received - before; };
  for (int i = 0; i < 20000; ++i) greedy.send(player_request(wire::player::kReqDevlist));
  modest.send(request(kLaser, wire::laser::kReqGetGeom));
  EXPECT_EQ(modest.read().size(), 1u);
  EXPECT_LE(served_before, 2 * limits::kTurnMessages + 1);
  EXPECT_EQ(server.status().messages_received - before, 20001u);
}

TEST_F(ServerTest, lets_a_client_wait_that_opens_and_closes_faster_than_the_driver_does) {
  wheels.holds_barriers = true;
  TestClient client(network, kPort), other(network, kPort);
  constexpr std::size_t kPairs = limits::kSessionAnswers + 10;
  for (std::size_t i = 0; i < kPairs; ++i) {
    client.send(open_request(kWheels, 0));
    client.send(open_request(kWheels, 0, 2));
  }
  std::size_t answers = client.read().size();
  EXPECT_EQ(answers, limits::kSessionAnswers);
  EXPECT_EQ(wheels.barriers.size(), limits::kSessionAnswers);
  EXPECT_EQ(outline(other.ask(open_request(kWheels, 0))), "ACK 3");
  while (!wheels.barriers.empty()) {
    wheels.barriers.clear();
    answers += client.read().size();
  }
  EXPECT_EQ(answers, 2 * kPairs);
}

TEST_F(ServerTest, does_not_make_a_client_wait_for_devices_to_close_that_has_finished_sending) {
  wheels.holds_barriers = true;
  TestClient client(network, kPort);
  client.send(open_request(kWheels, 0));
  client.peer.finish();
  EXPECT_EQ(outline(client.read()), "ACK 3");
  EXPECT_TRUE(client.peer.closed());
  wheels.barriers.clear();
  network.run();
}

TEST_F(ServerTest, counts_long_requests_for_more) {
  network.piece_bytes = 1u << 20;
  wheels.holds_requests = true;
  TestClient client(network, kPort);
  const Bytes long_name = wire::encode(wire::StrpropReq{std::string(8u << 20, 'x'), ""});
  for (int i = 0; i < 20; ++i) client.send(request(kWheels, wire::kReqGetStrprop, long_name));
  network.run();
  EXPECT_EQ(wheels.held.size(), 1u) << "more than the limit alone";
  wheels.held.clear();
}

TEST_F(ServerTest, counts_long_answers_for_more) {
  for (std::size_t i = 1; i < limits::kDevices; ++i)
    ASSERT_TRUE(server.add_device({kPort, kWheels, static_cast<std::uint16_t>(i)}, wheels));
  network.piece_bytes = network.window_bytes = 65536;
  TestClient flooder(network, kPort);
  flooder.peer.stall();
  constexpr std::size_t kRequests = 100, kAnswerBytes = 16 * limits::kDevices;
  for (std::size_t i = 0; i < kRequests; ++i) flooder.send(player_request(wire::player::kReqDevlist));
  network.run();
  EXPECT_LT(server.status().messages_received * kAnswerBytes, 2 * limits::kSessionAnswerBytes)
      << "with what is on its way";
  flooder.peer.read_on();
  EXPECT_EQ(flooder.read().size(), kRequests);
}

TEST_F(ServerTest, survives_garbage_of_every_seed) {
  TestClient good(network, kPort);
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    TestClient client(network, kPort);
    Rng rng(seed);
    Bytes garbage(rng.bits() % 400);
    for (std::byte& byte : garbage) byte = static_cast<std::byte>(rng.bits() % (seed % 2 ? 256 : 6));
    client.send(garbage);
    client.peer.finish();
    client.read();
  }
  EXPECT_EQ(server.status().sessions, 1u);
  EXPECT_EQ(outline(good.ask(player_request(wire::player::kReqDevlist))), "ACK 1");
}

TEST_F(ServerTest, refuses_clients_over_the_limit_and_takes_new_ones_when_others_leave) {
  std::vector<net::SimulatedPeer> peers;
  for (std::size_t i = 0; i < limits::kSessions; ++i) peers.push_back(network.connect(kPort));
  for (net::SimulatedPeer& peer : peers) peer.send(request(kWheels, position2d::kReqGetGeom));
  network.run();
  for (int i = 0; i < 2; ++i) peers.push_back(network.connect(kPort));
  network.run();
  EXPECT_EQ(server.status().sessions, limits::kSessions);
  EXPECT_EQ(server.status().sessions_refused, 2u);
  EXPECT_TRUE(peers.back().closed());
  peers.front().finish();
  network.run();
  EXPECT_EQ(TestClient(network, kPort).banner.size(), 32u);
}

TEST_F(ServerTest, lets_those_that_say_nothing_shut_out_nobody) {
  std::vector<net::SimulatedPeer> peers;
  for (std::size_t i = 0; i < limits::kSessions; ++i) peers.push_back(network.connect(kPort));
  peers[0].send(request(kWheels, position2d::kReqGetGeom));
  network.run();
  TestClient late(network, kPort);
  EXPECT_EQ(late.banner.size(), 32u);
  EXPECT_FALSE(peers[0].closed()) << "it has asked something";
  EXPECT_TRUE(peers[1].closed()) << "the first of the others";
  EXPECT_FALSE(peers[2].closed());
  EXPECT_EQ(server.status().sessions_silent, 1u);
  EXPECT_EQ(server.status().sessions_refused, 0u);
}

TEST_F(ServerTest, closes_a_client_that_never_says_anything_and_no_other) {
  TestClient mute(network, kPort), half(network, kPort), reader(network, kPort), asked(network, kPort);
  half.send(Bytes(20));
  reader.ask(open_request(kWheels, 0));
  asked.ask(player_request(wire::player::kReqDevlist));
  network.run_for(limits::kSilentSeconds - 1);
  EXPECT_EQ(server.status().sessions, 4u);
  network.run_for(2);
  EXPECT_TRUE(mute.peer.closed());
  EXPECT_TRUE(half.peer.closed());
  network.run_for(100 * limits::kSilentSeconds);
  EXPECT_EQ(server.status().sessions, 2u);
  EXPECT_EQ(server.status().sessions_silent, 2u);
}

TEST_F(ServerTest, gives_one_address_a_part_of_the_places_and_this_machine_all) {
  std::vector<net::SimulatedPeer> peers;
  const auto connect = [&](const std::string& host) {
    peers.push_back(network.connect(kPort, host));
    network.run();
    return !peers.back().closed();
  };
  for (std::size_t i = 0; i < limits::kSessionsOfHost; ++i)
    peers.push_back(network.connect(kPort, "192.0.2.1"));
  EXPECT_FALSE(connect("192.0.2.1"));
  EXPECT_EQ(server.status().sessions_refused, 1u);
  EXPECT_TRUE(connect("192.0.2.2"));
  EXPECT_TRUE(connect("127.0.0.1"));
  peers[0].vanish();
  network.run();
  EXPECT_TRUE(connect("192.0.2.1"));
  EXPECT_FALSE(connect("192.0.2.1"));
  for (std::size_t i = 0; i <= limits::kSessionsOfHost; ++i) peers.push_back(network.connect(kPort));
  EXPECT_TRUE(connect("127.0.0.1"));
}

TEST_F(ServerTest, keeps_a_device_running_that_the_program_holds) {
  ASSERT_TRUE(server.hold(wheels_id));
  EXPECT_EQ(wheels.starts, 1);
  TestClient client(network, kPort);
  client.ask(open_request(kWheels, 0));
  client.ask(open_request(kWheels, 0, 2));
  EXPECT_EQ(wheels.stops, 0);
  server.release(wheels_id);
  EXPECT_EQ(wheels.stops, 1);
}

TEST_F(ServerTest, lists_no_more_devices_than_a_list_holds_but_opens_them_all) {
  for (std::size_t i = 1; i <= limits::kDevices; ++i) {
    ASSERT_TRUE(server.add_device({kPort, kWheels, static_cast<std::uint16_t>(i)}, wheels));
  }
  TestClient client(network, kPort);
  const auto replies = client.ask(player_request(wire::player::kReqDevlist));
  ASSERT_EQ(outline(replies), "ACK 1");
  EXPECT_EQ(wire::decode<wire::player::DeviceDevlist>(replies[0].body)->devices.size(), limits::kDevices);
  EXPECT_EQ(access_of(client.ask(open_request(kWheels, limits::kDevices))[0]), 1);
}

/// A server with little memory for messages that have not come whole.
/// Clients that do not read, on a server that keeps little for them.
class Unread : public ServerTest {
 protected:
  static constexpr std::size_t kLimit = 4u << 20;
  Unread() {
    network.window_bytes = network.piece_bytes = 65536;
    EXPECT_EQ(*small.listen(7000), 7000);
    for (std::uint16_t i = 0; i < 2000; ++i) ids.push_back(*small.add_device({7000, kWheels, i}, wheels));
  }
  /// What is in the books besides bytes that somebody waits for: one portion of work.
  static constexpr std::size_t kSlack = limits::kSessionAnswerBytes + (256u << 10);

  Server small{network, {.output_bytes = kLimit}};
  std::vector<device::DeviceId> ids;
};

TEST_F(Unread, answers_of_all_clients_have_a_limit_and_the_largest_holder_goes) {
  TestClient modest(network, 7000);
  modest.peer.stall();
  modest.send(player_request(wire::player::kReqDevlist));
  std::vector<std::unique_ptr<TestClient>> greedy;
  for (int i = 0; i < 30; ++i) {
    greedy.push_back(std::make_unique<TestClient>(network, 7000));
    greedy.back()->peer.stall();
    for (int k = 0; k < 100; ++k) greedy.back()->send(player_request(wire::player::kReqDevlist));
    network.run();
    EXPECT_LE(small.status().output_bytes, kLimit + kSlack);
  }
  EXPECT_GT(small.status().sessions_broken, 20u);
  EXPECT_GT(small.status().sessions, 1u);
  modest.peer.read_on();
  EXPECT_EQ(modest.read().size(), 1u) << "it asked for little";
  EXPECT_EQ(TestClient(network, 7000).ask(player_request(wire::player::kReqDevlist)).size(), 1u);
  for (auto& client : greedy) client->peer.reset();
  network.run();
  EXPECT_LE(small.status().output_bytes, 100000u) << "nothing is kept for who is gone";
}

TEST_F(Unread, data_that_nobody_asks_for_count_although_nobody_speaks) {
  std::vector<std::unique_ptr<TestClient>> readers;
  for (std::uint16_t i = 0; i < 8; ++i) {
    readers.push_back(std::make_unique<TestClient>(network, 7000));
    readers.back()->ask(mode_request(wire::player::kDatamodePull));
    readers.back()->ask(open_request(kWheels, i));
  }
  for (int time = 0; time < 30; ++time) {
    for (std::size_t i = 0; i < readers.size(); ++i) small.publish({{ids[i], 1, 1.0 * time, Bytes(65536)}});
    network.run();
    EXPECT_LE(small.status().output_bytes, kLimit + kSlack);
  }
  EXPECT_EQ(small.status().sessions, readers.size());
}

TEST_F(Unread, data_gives_way_before_a_client_does) {
  std::vector<std::unique_ptr<TestClient>> readers;
  for (std::uint16_t i = 0; i < 8; ++i) {
    readers.push_back(std::make_unique<TestClient>(network, 7000));
    readers.back()->ask(open_request(kWheels, i));
    readers.back()->peer.stall();
  }
  for (int time = 0; time < 100; ++time) {
    std::vector<device::Publication> batch;
    for (std::size_t i = 0; i < readers.size(); ++i) batch.push_back({ids[i], 1, 1.0 * time, Bytes(65536)});
    small.publish(std::move(batch));
    network.run();
    EXPECT_LE(small.status().output_bytes, kLimit + kSlack);
  }
  EXPECT_GT(small.status().data_dropped, 0u);
  EXPECT_EQ(small.status().sessions_broken, 0u);
  for (auto& reader : readers) {
    reader->peer.read_on();
    EXPECT_FALSE(reader->read().empty());
  }
}

TEST_F(Unread, data_that_many_wait_for_counts_once) {
  std::vector<std::unique_ptr<TestClient>> readers;
  for (int i = 0; i < 50; ++i) {
    readers.push_back(std::make_unique<TestClient>(network, 7000));
    readers.back()->ask(open_request(kWheels, 0));
    readers.back()->peer.stall();
  }
  for (int time = 0; time < 30; ++time) {
    std::vector<device::Publication> batch;
    batch.push_back({ids[0], 1, 1.0 * time, Bytes(100000)});
    small.publish(std::move(batch));
    network.run();
  }
  EXPECT_EQ(small.status().data_dropped, 0u);
}

class LongMessages : public ::testing::Test {
 protected:
  LongMessages() {
    network.piece_bytes = 65536;
    EXPECT_EQ(*server.listen(kPort), kPort);
    EXPECT_TRUE(server.add_device({kPort, kWheels, 0}, wheels));
  }
  static Bytes long_command(std::size_t bytes) {
    Bytes command = wire::encode(position2d::CmdVel{});
    command.resize(bytes);
    return message(wire::MessageType::kCmd, kWheels, 0, position2d::kCmdVel, command);
  }
  /// Clients that announce a long command and send so many bytes of it.
  std::vector<TestClient> announce(std::size_t clients, std::size_t bytes) {
    const Bytes command = long_command(1u << 20);
    std::vector<TestClient> result;
    for (std::size_t i = 0; i < clients; ++i) {
      result.emplace_back(network, kPort).send({command.begin(), command.begin() + static_cast<int>(bytes)});
      network.run();
    }
    return result;
  }

  net::SimulatedNetwork network{12};
  FakeDriver wheels;
  Server server{network, {.input_bytes = 4u << 20}};
};

TEST_F(LongMessages, that_do_not_end_make_room_for_those_that_do) {
  TestClient slow(network, kPort);
  slow.send(Bytes(20));
  std::vector<TestClient> holders = announce(20, 300u << 10);
  TestClient honest(network, kPort);
  honest.ask(long_command(1u << 20));
  EXPECT_EQ(wheels.commands.size(), 1u);
  EXPECT_FALSE(honest.peer.closed());
  EXPECT_FALSE(slow.peer.closed()) << "what is short costs nothing";
  EXPECT_TRUE(holders.front().peer.closed());
  EXPECT_FALSE(holders.back().peer.closed());
  const std::uint64_t closed = server.status().sessions_broken;
  for (TestClient& holder : holders) holder.peer.vanish();
  honest.ask(long_command(1u << 20));
  EXPECT_EQ(wheels.commands.size(), 2u);
  EXPECT_EQ(server.status().sessions_broken, closed);
}

TEST_F(LongMessages, give_their_memory_back_when_they_have_come) {
  std::vector<TestClient> clients;
  for (int i = 0; i < 20; ++i) {
    Bytes bytes = long_command(1u << 20);
    bytes.push_back({});  // the next message begins
    clients.emplace_back(network, kPort).ask(bytes);
  }
  EXPECT_EQ(wheels.commands.size(), 20u);
  EXPECT_EQ(server.status().sessions_broken, 0u);
}

TEST_F(LongMessages, count_only_above_what_each_client_may_have) {
  const std::vector<TestClient> clients = announce(200, 60u << 10);
  EXPECT_EQ(server.status().sessions_broken, 0u);
}

}  // namespace
}  // namespace playhouse::server
