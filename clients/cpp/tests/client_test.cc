#include "playhouse_client/client.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "fake_server.h"
#include "playhouse/wire/generated/player.h"
#include "playhouse/wire/generated/simulation.h"
#include "playhouse_client/position2d.h"
#include "playhouse_client/robot.h"
#include "playhouse_client/scan.h"
#include "testing_scripts.h"

namespace playhouse::client {
namespace {

namespace position2d = wire::position2d;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using wire::MessageType;

std::vector<double> commanded_speeds(const FakeServer& server) {
  std::vector<double> speeds;
  for (const Received& message : server.received()) {
    if (message.header.type == MessageType::kCmd) {
      speeds.push_back(wire::decode<position2d::CmdVel>(message.body)->vel.px);
    }
  }
  return speeds;
}

TEST(Address, DefaultsWhatIsMissingAndRefusesWhatIsNone) {
  EXPECT_EQ(parse_address("robot")->host, "robot");
  EXPECT_EQ(parse_address("robot")->port, kDefaultPort);
  EXPECT_EQ(parse_address("localhost:7000")->host, "localhost");
  EXPECT_EQ(parse_address("")->host, "127.0.0.1");
  EXPECT_EQ(parse_address(":7000")->host, "127.0.0.1");
  EXPECT_EQ(parse_address(":7000")->port, 7000);
  EXPECT_EQ(parse_address("[::1]:7000")->host, "::1");
  EXPECT_EQ(parse_address("[::1]:7000")->port, 7000);
  EXPECT_EQ(parse_address("[fe80::2]")->host, "fe80::2");
  EXPECT_EQ(parse_address("[fe80::2]")->port, kDefaultPort);
  EXPECT_FALSE(parse_address("[::1]:port"));
  EXPECT_FALSE(parse_address("robot:port"));
  EXPECT_FALSE(parse_address("robot:0"));
  EXPECT_FALSE(parse_address("robot:66666"));
}

TEST(Connecting, SaysWhenNobodyIsThere) {
  std::string address;
  {
    FakeServer server([](Peer&) {});
    address = server.address();
    connect(server, {.mode = Mode::kPush});
  }
  const Result<Client> client = Client::connect(address);
  ASSERT_FALSE(client);
  EXPECT_THAT(client.error().line(), HasSubstr("cannot connect"));
}

TEST(Connecting, SaysWhenTheServerIsOfAnotherKind) {
  FakeServer server([](Peer&) {}, "220 mail.example.org ESMTP ready");
  const Result<Client> client = Client::connect(server.address());
  ASSERT_FALSE(client);
  EXPECT_THAT(client.error().line(), HasSubstr("not a Player server"));
}

TEST(Reading, ARoundEndsWithSynchAndBringsEverything) {
  FakeServer server(rounds([](Peer& peer, const Received& message) {
    peer.answer(message);
    peer.position(1);
    peer.position(2, 7.5);
    peer.synch();
  }));
  Client client = connect(server);
  Position2d robot = open_robot(client);
  EXPECT_EQ(*client.read(), 2u);
  EXPECT_EQ(robot.state()->pose.x, 2);
  EXPECT_EQ(robot.state()->time, 7.5);
}

TEST(Reading, MessagesInSingleBytesArriveWhole) {
  FakeServer server(rounds([](Peer& peer, const Received& message) {
    peer.dribble();
    peer.answer(message);
    peer.position(3);
    peer.synch();
  }));
  Client client = connect(server);
  Position2d robot = open_robot(client);
  EXPECT_EQ(*client.read(), 1u);
  EXPECT_EQ(robot.state()->pose.x, 3);
}

TEST(Reading, NoDataInTimeIsNoErrorAndTheRoundGoesOn) {
  FakeServer server(rounds([](Peer& peer, const Received& message) {
    if (message.header.interf == wire::player::kCode) {
      peer.answer(message);  // and nothing else
      return;
    }
    peer.answer(message, wire::encode(position2d::Geom()));
    peer.position(4);
    peer.synch();
  }));
  {
    Client client = connect(server);
    Position2d robot = open_robot(client);
    EXPECT_EQ(*client.read(kShort), 0u);
    EXPECT_TRUE(robot.geometry());
    EXPECT_EQ(*client.read(), 1u);
    EXPECT_EQ(robot.state()->pose.x, 4);
  }
  server.finish();
  const auto asked =
      std::count_if(server.received().begin(), server.received().end(), [](const Received& message) {
        return message.header.interf == wire::player::kCode &&
               message.header.subtype == wire::player::kReqData;
      });
  EXPECT_EQ(asked, 1);
}

TEST(Reading, ARoundThatEndsWhileARequestWaitsIsTheNextRead) {
  FakeServer server(rounds([](Peer& peer, const Received& message) {
    if (message.header.interf == wire::player::kCode) {
      peer.answer(message);  // and nothing else
      return;
    }
    peer.position(4);
    peer.synch();
    peer.answer(message, wire::encode(position2d::Geom()));
  }));
  Client client = connect(server);
  Position2d robot = open_robot(client);
  EXPECT_EQ(*client.read(kShort), 0u);
  EXPECT_TRUE(robot.geometry());
  EXPECT_EQ(*client.read(kShort), 1u);
  EXPECT_EQ(*client.read(kShort), 0u);
}

TEST(Reading, InPushModeBringsWhatHasArrived) {
  FakeServer server(rounds([](Peer& peer, const Received& message) {
    peer.answer(message, wire::encode(position2d::Geom()));
    peer.position(5);
  }));
  Client client = connect(server, {.mode = Mode::kPush});
  Position2d robot = open_robot(client);
  ASSERT_TRUE(robot.geometry());
  EXPECT_FALSE(robot.state()) << "no data yet, and that is no pose of (0, 0, 0)";
  EXPECT_EQ(*client.read(), 1u);
  EXPECT_EQ(robot.state()->pose.x, 5);
}

TEST(Reading, LostMessagesAreCounted) {
  FakeServer server(rounds([](Peer& peer, const Received& message) {
    peer.answer(message);
    peer.position(1);
    peer.overflow(41);
  }));
  Client client = connect(server);
  Position2d robot = open_robot(client);
  ASSERT_TRUE(client.read());
  EXPECT_EQ(client.overflow_count(), 41u);
}

TEST(Reading, WhatMakesNoSenseIsSkippedAndCounted) {
  FakeServer server(rounds([](Peer& peer, const Received& message) {
    peer.answer(message);
    const std::string junk = "1234";
    const auto body = std::as_bytes(std::span(junk));
    wire::Header header;
    header.interf = position2d::kCode;
    header.subtype = 99;  // no such kind of data
    peer.say(header, body);
    header.subtype = position2d::kDataState;  // too short
    peer.say(header, body);
    header.index = 9;  // not open
    peer.say(header, wire::encode(position2d::Data()));
    header.type = MessageType::kNack;  // nobody asked
    peer.say(header, {});
    header.type = static_cast<MessageType>(77);
    peer.say(header, {});
    peer.position(6);
    peer.synch();
  }));
  Client client = connect(server);
  Position2d robot = open_robot(client);
  EXPECT_EQ(*client.read(), 1u);
  EXPECT_EQ(robot.state()->pose.x, 6);
  EXPECT_EQ(client.skipped_count(), 5u);
}

TEST(Reading, ASizeOverTheLimitEndsTheConnection) {
  FakeServer server(rounds([](Peer& peer, const Received& message) {
    peer.answer(message);
    wire::Header header;
    header.size = 0x7FFFFFFF;
    std::array<std::byte, limits::kHeaderBytes> head;
    wire::encode_header(header, head);
    peer.send(head);
  }));
  Client client = connect(server);
  Position2d robot = open_robot(client);
  const auto read = client.read();
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().line(), HasSubstr("over the wire's limit"));
  EXPECT_FALSE(client.connected());
  EXPECT_FALSE(robot.drive(1, 0));
}

TEST(Reading, CallbacksMayAskAndCloseButNotRead) {
  FakeServer server(rounds([](Peer& peer, const Received& message) {
    const bool to_server = message.header.interf == wire::player::kCode;
    peer.answer(message, to_server ? std::vector<std::byte>() : wire::encode(position2d::Geom()));
    if (!to_server) return;
    peer.position(1);
    peer.position(2);
    peer.synch();
  }));
  Client client = connect(server);
  Position2d robot = open_robot(client);
  int calls = 0;
  robot.device().on_data([&](std::uint8_t subtype, std::span<const std::byte> body, double) {
    ++calls;
    EXPECT_EQ(subtype, position2d::kDataState);
    EXPECT_EQ(wire::decode<position2d::Data>(body)->pos.px, 1);
    EXPECT_TRUE(robot.geometry());
    EXPECT_FALSE(client.read());
    EXPECT_TRUE(robot.close());
  });
  ASSERT_TRUE(client.read());
  EXPECT_EQ(calls, 1);
}

TEST(Asking, ARefusalIsAnErrorAndTheConnectionStays) {
  int asked = 0;
  FakeServer server(rounds([&](Peer& peer, const Received& message) {
    const auto type = ++asked == 1 ? MessageType::kNack : MessageType::kAck;
    peer.answer(message, wire::encode(position2d::Geom()), type);
  }));
  Client client = connect(server);
  Position2d robot = open_robot(client);
  const auto refused = robot.geometry();
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().line(), HasSubstr("refused: position2d.req.get_geom to position2d:0"));
  EXPECT_TRUE(robot.geometry());
}

/// Holds the first request until the second, then answers both in order, the second with `number`.
void answer_late(Peer& peer, std::vector<Received>& held, const Received& message, bool returns_numbers) {
  held.push_back(message);
  for (std::size_t i = 0; held.size() == 2 && i < 2; ++i) {
    wire::IntpropReq body{"x", static_cast<std::int32_t>(i + 1)};
    if (!returns_numbers) held[i].header.seq = 0;
    peer.answer(held[i], wire::encode(body));
  }
}

class LateAnswers : public testing::TestWithParam<bool> {};

TEST_P(LateAnswers, AreNotTakenForAnothers) {
  std::vector<Received> held;
  FakeServer server(
      rounds([&](Peer& peer, const Received& message) { answer_late(peer, held, message, GetParam()); }));
  Client client = connect(server, {.timeout = Seconds{2}});  // long for a machine that is busy
  Result<Device> device = Device::open(client, position2d::kCode, 0);
  ASSERT_TRUE(device);
  const auto first = device->get_int("x");
  ASSERT_FALSE(first);
  EXPECT_THAT(first.error().line(), HasSubstr("no answer in time: universal.req.get_intprop"));
  const auto second = device->get_int("x");
  ASSERT_TRUE(second);
  EXPECT_EQ(*second, 2);
}

INSTANTIATE_TEST_SUITE_P(ServersThatReturnNumbersAndServersThatDoNot, LateAnswers, testing::Bool());

TEST(Asking, AServerThatGoesIsNoticed) {
  FakeServer server([](Peer& peer) {
    for (int i = 0; i < 3; ++i) {
      const auto message = peer.receive();
      if (message && i < 2) peer.answer(*message, message->body);
    }
  });
  Client client = connect(server);
  Position2d robot = open_robot(client);
  const auto lost = robot.geometry();
  ASSERT_FALSE(lost);
  EXPECT_THAT(lost.error().line(), HasSubstr("the server"));
  EXPECT_FALSE(client.connected());
  EXPECT_FALSE(client.read());
}

TEST(Asking, AnAnswerThatDoesNotDecodeNamesTheFault) {
  const std::string junk = "1234";
  FakeServer server(rounds(
      [&](Peer& peer, const Received& message) { peer.answer(message, std::as_bytes(std::span(junk))); }));
  Client client = connect(server);
  Position2d robot = open_robot(client);
  const auto geometry = robot.geometry();
  ASSERT_FALSE(geometry);
  EXPECT_THAT(geometry.error().line(), HasSubstr("does not decode"));
}

TEST(Asking, ADriverThatRefusesToStartIsAnError) {
  FakeServer server([](Peer& peer) {
    while (const auto message = peer.receive()) {
      wire::player::DeviceReq granted;
      granted.access = wire::player::kErrorMode;
      peer.answer(*message, wire::encode(granted));
    }
  });
  Client client = connect(server);
  const auto robot = Position2d::open(client, 0);
  ASSERT_FALSE(robot);
  EXPECT_THAT(robot.error().line(), HasSubstr("cannot open position2d:0: the driver refuses"));
}

TEST(Ending, AMovingRobotIsStoppedBeforeItsDeviceIsClosed) {
  FakeServer server(silent());
  {
    Client client = connect(server);
    Position2d robot = open_robot(client);
    ASSERT_TRUE(robot.drive(0.4, 0.1));
  }
  server.finish();
  EXPECT_THAT(commanded_speeds(server), testing::ElementsAre(0.4, 0.0));
  EXPECT_EQ(wire::decode<wire::player::DeviceReq>(server.received().back().body)->access,
            wire::player::kCloseMode);
}

TEST(Ending, ARobotThatStandsGetsNoFurtherCommand) {
  FakeServer server(silent());
  {
    Client client = connect(server);
    Position2d robot = open_robot(client);
    Position2d moved = std::move(robot);
    ASSERT_TRUE(moved.drive(0.4, 0));
    ASSERT_TRUE(moved.stop());
  }
  server.finish();
  EXPECT_THAT(commanded_speeds(server), testing::ElementsAre(0.4, 0.0));
}

TEST(Ending, ADeviceMayOutliveItsClient) {
  FakeServer server(silent());
  std::optional<Position2d> robot;
  {
    Client client = connect(server);
    robot.emplace(open_robot(client));
  }
  EXPECT_FALSE(robot->drive(1, 0));
}

/// A server of two ports' devices, which tells the names of their models in two answers.
FakeServer::Script named_devices(const std::string& first, const std::string& rest) {
  return rounds([=](Peer& peer, const Received& message) {
    if (message.header.interf == wire::simulation::kCode) {
      const auto question = *wire::decode<wire::simulation::PropertyReq>(message.body);
      const bool begins = question.index == 0;
      peer.answer(message, wire::encode(wire::simulation::PropertyReq{
                               question.name, question.prop, begins ? 2u : 0u, begins ? first : rest}));
    } else if (message.header.subtype == wire::player::kReqDevlist) {
      peer.answer(message, wire::encode(wire::player::DeviceDevlist{
                               {{0, 7000, 31, 0}, {0, 7000, 4, 12}, {0, 7000, 6, 12}, {0, 7000, 20, 0}}}));
    } else {
      peer.answer(message, wire::encode(wire::player::DeviceDriverinfo{{}, wire::c_string("stage")}));
    }
  });
}

constexpr const char* kFirstModels =
    "0\twall\tmodel\t\t\n"
    "1\tguest\tpioneer2dx\t\t7000:position2d:12\n";
constexpr const char* kOtherModels =
    "2\tguest.\\tlaser\tsick\tguest\t7000:ranger:12 7000:laser:12 7001:laser:0\n"
    "3\thost\tpioneer2dx\t\t7001:position2d:0\n";

TEST(Names, OfModelsComeWithTheDeviceList) {
  FakeServer server(named_devices(kFirstModels, kOtherModels));
  Client client = connect(server);
  const auto devices = client.devices();
  ASSERT_TRUE(devices);
  std::vector<std::string> lines;
  for (const DeviceEntry& device : *devices)
    lines.push_back(device.name() + " " + device.driver + " " + device.model + " of " + device.robot);
  EXPECT_THAT(lines, testing::ElementsAre("simulation:0 stage  of ", "position2d:12 stage guest of guest",
                                          "laser:12 stage guest.\tlaser of guest", "dio:0 stage  of "));
}

TEST(Names, OpenTheDevicesOfARobot) {
  FakeServer server(named_devices(kFirstModels, kOtherModels));
  Client client = connect(server);
  const auto guest = client.robot("guest");
  ASSERT_TRUE(guest) << guest.error().line();
  EXPECT_EQ(guest->type(), "pioneer2dx");
  const auto wheels = guest->position2d();
  ASSERT_TRUE(wheels);
  const auto laser = client.robot("guest.\tlaser")->laser();
  ASSERT_TRUE(laser) << laser.error().line();
  const auto sonar = guest->sonar();
  ASSERT_FALSE(sonar);
  EXPECT_EQ(sonar.error().text, "robot \"guest\" has no sonar (it has position2d:12, ranger:12, laser:12)");
  EXPECT_THAT(guest->laser(1).error().text, HasSubstr("has 1 laser only"));
  EXPECT_THAT(guest->device("lazer").error().text, HasSubstr("did you mean \"laser\"?"));
}

TEST(Names, RobotsAreTheModelsAtTheTopWithDevicesOnThisPort) {
  FakeServer server(named_devices(kFirstModels, kOtherModels));
  Client client = connect(server);
  const auto robots = client.robots();
  ASSERT_TRUE(robots);
  ASSERT_EQ(robots->size(), 1u);
  EXPECT_EQ(robots->front().name(), "guest");
}

TEST(Names, ThatAreWrongAreErrorsWithTheNearestOne) {
  FakeServer server(named_devices(kFirstModels, kOtherModels));
  Client client = connect(server);
  const auto robot = client.robot("gust");
  ASSERT_FALSE(robot);
  EXPECT_THAT(robot.error().text, HasSubstr("no robot \"gust\" (did you mean \"guest\"?)"));
}

TEST(Names, ThatAServerDoesNotTellAreEmpty) {
  FakeServer server(rounds([](Peer& peer, const Received& message) {
    if (message.header.interf == wire::simulation::kCode) return peer.answer(message, {}, MessageType::kNack);
    peer.answer(message, message.header.subtype == wire::player::kReqDevlist
                             ? wire::encode(wire::player::DeviceDevlist{{{0, 6665, 31, 0}}})
                             : wire::encode(wire::player::DeviceDriverinfo{{}, wire::c_string("stage")}));
  }));
  Client client = connect(server);
  const auto devices = client.devices();
  ASSERT_TRUE(devices);
  EXPECT_EQ(devices->front().model, "");
  const auto robot = client.robot("guest");
  ASSERT_FALSE(robot);
  EXPECT_THAT(robot.error().text, HasSubstr("tells no names"));
}

TEST(Names, FromAServerThatMakesNoSenseAreAnError) {
  for (const char* text : {"1\tfirst\t\t\t\n", "0\tguest\t\t\n", "0\tguest\tt\tnobody\t\n",
                           "0\tguest\tt\t\t\tmore\n", "0\tguest\tt\t\t\n"}) {
    FakeServer server(named_devices(text, kOtherModels));  // the last one goes on with row 2
    Client client = connect(server);
    EXPECT_FALSE(client.models()) << text;
  }
}

TEST(Driving, WithNumbersThatAreNoneIsAnErrorAndSendsNothing) {
  FakeServer server(silent());
  {
    Client client = connect(server);
    Position2d robot = open_robot(client);
    const auto driven = robot.drive(std::nan(""), 0);
    ASSERT_FALSE(driven);
    EXPECT_EQ(driven.error().text, "position2d:0: drive takes finite numbers, not nan");
    EXPECT_FALSE(robot.drive(0, std::numeric_limits<double>::infinity()));
    EXPECT_FALSE(robot.drive_car(0, std::nan("")));
    EXPECT_FALSE(robot.go_to({0, std::nan(""), 0}));
    EXPECT_FALSE(robot.set_odometry({0, 0, std::nan("")}));
  }
  server.finish();
  EXPECT_THAT(commanded_speeds(server), testing::IsEmpty());
}

TEST(Ending, AClosedDeviceSaysSo) {
  FakeServer server(silent());
  Client client = connect(server);
  Position2d robot = open_robot(client);
  ASSERT_TRUE(robot.close());
  const auto driven = robot.drive(1, 0);
  ASSERT_FALSE(driven);
  EXPECT_EQ(driven.error().text, "position2d:0 is closed");
  EXPECT_FALSE(robot.geometry());
  EXPECT_FALSE(robot.state());
  EXPECT_TRUE(robot.close());
}

TEST(Ending, AClosedClientSaysSo) {
  FakeServer server(silent());
  Client client = connect(server);
  Position2d robot = open_robot(client);
  client.close();
  EXPECT_THAT(robot.drive(1, 0).error().line(), HasSubstr("closed"));
  EXPECT_THAT(client.read().error().line(), HasSubstr("closed"));
  EXPECT_THAT(client.devices().error().line(), HasSubstr("closed"));
}

TEST(Scan, FindsTheNearestThingBetweenTwoDirections) {
  Scan scan;
  scan.ranges = {3, 1, 2};
  scan.angles = spread_angles(-1, 1, 3);
  scan.max_range = 8;
  EXPECT_THAT(scan.angles, testing::ElementsAre(-1, 0, 1));
  EXPECT_EQ(scan.nearest(-2, 2), 1);
  EXPECT_EQ(scan.nearest(0.5, 2), 2);
  EXPECT_EQ(scan.nearest(2, 3), 8);
  EXPECT_NEAR(scan.points()[0].y, -3 * std::sin(1), 1e-12);
}

}  // namespace
}  // namespace playhouse::client
