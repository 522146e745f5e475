// What a client makes of servers that are slow, silent, busy, faulty or gone.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fake_server.h"

namespace playhouse_c {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

bool asks_data(const Received &message) {
  return message.header.interface_code == PH_PLAYER_CODE &&
         message.header.subtype == PH_PLAYER_REQ_DATA->subtype;
}

ph_position2d *base(const Client &client, int index = 0, ph_access access = PH_ACCESS_ALL) {
  ph_error error = {PH_OK, ""};
  ph_position2d *made = ph_position2d_open(client.get(), index, access, &error);
  EXPECT_NE(made, nullptr) << error.text;
  return made;
}

ph_device *any(const Client &client, const char *interface_name) {
  ph_error error = {PH_OK, ""};
  ph_device *made = ph_device_open(client.get(), interface_name, 0, PH_ACCESS_ALL, &error);
  EXPECT_NE(made, nullptr) << error.text;
  return made;
}

std::size_t read_one(const Client &client) {
  std::size_t count = 0;
  EXPECT_WORKS(ph_client_read(client.get(), PH_OWN_TIMEOUT, &count, &error));
  return count;
}

double x_of(ph_position2d *robot) {
  ph_state state{};
  EXPECT_WORKS(ph_position2d_state(robot, &state, &error));
  return state.pose.x;
}

Bytes geom() {
  return body(ph_position2d_geom_type, ph_position2d_geom{});
}

/// A server that takes commands and answers nothing but opening and closing.
FakeServer::Script quiet() {
  return script([](Peer &, const Received &) { return true; });
}

// --- connecting

TEST(Connecting, NobodyThere) {
  std::string address;
  {
    FakeServer server([](Peer &) {});
    address = server.address();
    connected(address, PH_MODE_PUSH);
  }
  EXPECT_REFUSES(ph_connect(address.c_str(), nullptr, &error), PH_CONNECTION_LOST,
                 address + ": cannot connect: Connection refused");
}

TEST(Connecting, AServerOfAnotherKind) {
  FakeServer server([](Peer &) {}, "220 mail.example.org ESMTP ready now");
  EXPECT_REFUSES(ph_connect(server.address().c_str(), nullptr, &error), PH_CONNECTION_LOST,
                 "not a Player server (it says '220 mail");
}

TEST(Connecting, ABannerInPieces) {
  FakeServer server(
      [](Peer &peer) {
        peer.dribble();
        const std::string banner = "Player v.3.1";
        Bytes bytes(banner.begin(), banner.end());
        bytes.resize(32);
        peer.send(bytes);
      },
      "");
  const Client client = connected(server.address(), PH_MODE_PUSH);
  EXPECT_STREQ(ph_client_banner(client.get()), "Player v.3.1");
}

TEST(Connecting, ASilentServerIsNotWaitedForLongerThanTheTimeOut) {
  FakeServer server([](Peer &peer) { peer.receive(); }, "");
  const ph_options options = {PH_MODE_PUSH, 0.02, nullptr};
  EXPECT_REFUSES(ph_connect(server.address().c_str(), &options, &error), PH_CONNECTION_LOST,
                 "cannot connect: no banner in time");
}

TEST(Connecting, AddressesAreHostsAndPorts) {
  EXPECT_REFUSES(ph_connect("[::1]:1", nullptr, &error), PH_CONNECTION_LOST, "::1:1: cannot connect");
  EXPECT_REFUSES(ph_connect(":1", nullptr, &error), PH_CONNECTION_LOST, "127.0.0.1:1: cannot connect");
  EXPECT_REFUSES(ph_connect("no such host", nullptr, &error), PH_CONNECTION_LOST,
                 "no such host:6665: cannot connect");
  for (const char *address :
       {"[::1]:", "localhost:port", "127.0.0.1:70000", "127.0.0.1:0", "a:99999999999999999999"}) {
    EXPECT_REFUSES(ph_connect(address, nullptr, &error), PH_CONNECTION_LOST, "is not HOST or HOST:PORT");
  }
  const ph_options options = {PH_MODE_PULL, kNan, nullptr};
  EXPECT_REFUSES(ph_connect(":1", &options, &error), PH_INVALID_VALUE,
                 "invalid time-out of nan s: 0 or more is valid");
}

// --- reading

TEST(Reading, ARoundEndsWithSynchAndBringsEverything) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    peer.answer(message);
    peer.position(1.0);
    peer.position(2.0, 7.5);
    peer.synch();
    return true;
  }));
  const Client client = connected(server.address());
  ph_position2d *robot = base(client);
  EXPECT_EQ(read_one(client), 2U);
  EXPECT_EQ(x_of(robot), 2.0);
  EXPECT_EQ(ph_device_timestamp(ph_position2d_device(robot)), 7.5);
  EXPECT_TRUE(ph_device_take_fresh(ph_position2d_device(robot)));
  EXPECT_FALSE(ph_device_fresh(ph_position2d_device(robot)));
}

TEST(Reading, AModeThatDoesNotExistIsNotSent) {
  FakeServer server(script([](Peer &, const Received &) { return false; }));
  const Client client = connected(server.address());
  ph_error error;
  EXPECT_EQ(ph_client_set_mode(client.get(), static_cast<ph_mode>(3), &error), PH_INVALID_VALUE);
  EXPECT_STREQ(error.text, "a mode is PH_MODE_PUSH or PH_MODE_PULL, not 3");
}

TEST(Reading, MessagesInSingleBytesArriveWhole) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    peer.dribble();
    peer.answer(message);
    peer.position(3.0);
    peer.synch();
    return true;
  }));
  const Client client = connected(server.address());
  ph_position2d *robot = base(client);
  EXPECT_EQ(read_one(client), 1U);
  EXPECT_EQ(x_of(robot), 3.0);
}

TEST(Reading, ARoundThatEndsWhileARequestWaitsIsTheNextRead) {
  int asked = 0;
  FakeServer server(script([&](Peer &peer, const Received &message) {
    if (asks_data(message)) {
      ++asked;
      peer.answer(message);  // and nothing else
    } else {
      peer.position(4.0);
      peer.synch();
      peer.answer(message, geom());
    }
    return true;
  }));
  {
    const Client client = connected(server.address());
    ph_position2d *robot = base(client);
    ph_geometry geometry;
    EXPECT_FAILS(ph_client_read(client.get(), 0.02, nullptr, &error), PH_REQUEST_TIMEOUT, "no data in time");
    EXPECT_WORKS(ph_position2d_geometry(robot, &geometry, &error));
    EXPECT_EQ(read_one(client), 1U);
  }
  server.finish();
  EXPECT_EQ(asked, 1);
}

TEST(Reading, LostMessagesAreCountedAndNotAnError) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    peer.answer(message);
    peer.position(1.0);
    peer.overflow(41);
    return true;
  }));
  const Client client = connected(server.address());
  base(client);
  read_one(client);
  EXPECT_EQ(ph_client_overflow_count(client.get()), 41U);
}

TEST(Reading, TheServersCountOfLostMessagesIsAskedFor) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    peer.answer(message, body(ph_common_intprop_req_type, ph_common_intprop_req{"lost", 5, 17}));
    return true;
  }));
  const Client client = connected(server.address());
  std::uint64_t count = 0;
  EXPECT_WORKS(ph_client_lost_count(client.get(), &count, &error));
  EXPECT_EQ(count, 17U);
}

TEST(Reading, DataThatComeBeforeAnAnswerWaitForRead) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    peer.position(5.0);
    peer.answer(message, geom());
    return true;
  }));
  const Client client = connected(server.address(), PH_MODE_PUSH);
  ph_position2d *robot = base(client);
  ph_geometry geometry;
  ph_state state;
  EXPECT_WORKS(ph_position2d_geometry(robot, &geometry, &error));
  EXPECT_FAILS(ph_position2d_state(robot, &state, &error), PH_NO_DATA,
               "position2d:0 has sent no data yet; next_data() waits for them");
  EXPECT_EQ(ph_device_latest(ph_position2d_device(robot), PH_POSITION2D_DATA_STATE), nullptr);
  EXPECT_EQ(read_one(client), 1U);
  EXPECT_EQ(x_of(robot), 5.0);
}

TEST(Reading, OfDataThatWaitForAReadTheOldestAreDroppedAndCounted) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    for (int x = 0; x < 1030; ++x) peer.position(x);
    peer.answer(message, geom());
    return true;
  }));
  const Client client = connected(server.address(), PH_MODE_PUSH);
  ph_position2d *robot = base(client);
  ph_geometry geometry;
  EXPECT_WORKS(ph_position2d_geometry(robot, &geometry, &error));
  EXPECT_EQ(read_one(client), 1024U);
  EXPECT_EQ(ph_client_overflow_count(client.get()), 6U);
}

TEST(Reading, DataOfOthersDoNotProlongTheTimeOutOfOne) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    peer.answer(message);
    peer.data(PH_LASER_DATA_SCAN, body(ph_laser_data_type, ph_laser_data{}));
    peer.synch();
    return true;
  }));
  const Client client = connected(server.address());
  ph_position2d *robot = base(client);
  ph_device *laser = any(client, "laser");
  EXPECT_FAILS(ph_position2d_next_data(robot, 0.05, &error), PH_REQUEST_TIMEOUT,
               "no data of position2d:0 in 0.05 s");
  EXPECT_TRUE(ph_device_fresh(laser));
}

TEST(Reading, AServerThatRefusesDataIsAnError) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    peer.answer(message, {}, PH_KIND_NACK);
    return true;
  }));
  const Client client = connected(server.address());
  for (int i = 0; i < 2; ++i) {
    EXPECT_FAILS(ph_client_read(client.get(), PH_OWN_TIMEOUT, nullptr, &error), PH_REQUEST_REFUSED,
                 "the server refuses to send data");
  }
}

TEST(Reading, WhatMakesNoSenseIsSkippedAndCounted) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    const auto say = [&](std::uint16_t index, int kind, int subtype, const Bytes &body) {
      ph_header header{};
      header.interface_code = 4;
      header.index = index;
      header.kind = static_cast<std::uint8_t>(kind);
      header.subtype = static_cast<std::uint8_t>(subtype);
      peer.say(header, body);
    };
    peer.answer(message);
    say(0, PH_KIND_DATA, 99, {1, 2, 3, 4});  // no such kind of data
    say(0, PH_KIND_DATA, 1, {1, 2, 3, 4});   // too short
    say(9, PH_KIND_DATA, 1,
        body(ph_position2d_data_type, ph_position2d_data{}));  // a device that is not open
    say(0, PH_KIND_NACK, 5, {});                               // nobody asked
    say(0, 77, 5, {});                                         // no such kind of message
    peer.position(6.0);
    peer.synch();
    return true;
  }));
  const Client client = connected(server.address());
  ph_position2d *robot = base(client);
  EXPECT_EQ(read_one(client), 1U);
  EXPECT_EQ(x_of(robot), 6.0);
  EXPECT_EQ(ph_client_skipped_count(client.get()), 5U);
}

TEST(Reading, ASizeOverTheLimitEndsTheConnection) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    peer.answer(message);
    Bytes head(PH_HEADER_BYTES);
    ph_header header{};
    header.size = 0x7FFFFFFF;
    ph_header_encode(&header, head.data());
    peer.send(head);
    return true;
  }));
  const Client client = connected(server.address());
  EXPECT_FAILS(ph_client_read(client.get(), PH_OWN_TIMEOUT, nullptr, &error), PH_CONNECTION_LOST,
               "a header announces 2147483647 bytes, over the limit");
  EXPECT_FALSE(ph_client_connected(client.get()));
}

/// What a callback does, and what became of it.
struct Reaction {
  ph_client *client;
  ph_position2d *robot;
  ph_position2d *other = nullptr;
  std::vector<double> seen = {};
  std::string fault = {};
  ph_value *kept = nullptr;
};

TEST(Reading, CallbacksMayAskButNotReadAndKeepValues) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    const bool round = asks_data(message);
    peer.answer(message, round ? Bytes() : geom());
    if (round) {
      peer.position(1.0);
      peer.synch();
    }
    return true;
  }));
  const Client client = connected(server.address());
  ph_position2d *robot = base(client);
  Reaction reaction{client.get(), robot};
  ph_device_on_data(
      ph_position2d_device(robot),
      [](void *context, const ph_value *value) {
        auto *self = static_cast<Reaction *>(context);
        ph_geometry geometry;
        EXPECT_WORKS(ph_position2d_geometry(self->robot, &geometry, &error));
        ph_error error;
        EXPECT_EQ(ph_client_read(self->client, PH_OWN_TIMEOUT, nullptr, &error), PH_MISUSED);
        self->fault = error.text;
        if (self->kept == nullptr) self->kept = ph_value_keep(value);
      },
      &reaction);
  read_one(client);
  read_one(client);
  EXPECT_THAT(reaction.fault, HasSubstr("from a callback"));
  ASSERT_NE(reaction.kept, nullptr);
  EXPECT_EQ(static_cast<const ph_position2d_data *>(reaction.kept->data)->pos.px, 1.0);
  ph_value_free(reaction.kept);
}

TEST(Reading, CallbacksMayFreeTheirDeviceAndOthers) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    peer.answer(message);
    peer.position(1.0);
    peer.position(2.0);
    peer.synch();
    return true;
  }));
  const Client client = connected(server.address());
  Reaction reaction{client.get(), base(client), base(client)};
  const auto see = [](void *context, const ph_value *value) {
    auto *self = static_cast<Reaction *>(context);
    self->seen.push_back(static_cast<const ph_position2d_data *>(value->data)->pos.px);
    ph_position2d_free(self->robot);
    ph_position2d_free(self->other);
  };
  ph_device_on_data(ph_position2d_device(reaction.robot), see, &reaction);
  ph_device_on_data(ph_position2d_device(reaction.other), see, &reaction);
  read_one(client);
  EXPECT_THAT(reaction.seen, ElementsAre(1.0));
  EXPECT_EQ(ph_client_skipped_count(client.get()), 1U);
}

// --- asking

TEST(Asking, ARefusalIsAnErrorAndTheConnectionStays) {
  int asked = 0;
  FakeServer server(script([&](Peer &peer, const Received &message) {
    peer.answer(message, geom(), ++asked == 1 ? PH_KIND_NACK : PH_KIND_ACK);
    return true;
  }));
  const Client client = connected(server.address());
  ph_position2d *robot = base(client);
  ph_geometry geometry;
  EXPECT_FAILS(ph_position2d_geometry(robot, &geometry, &error), PH_REQUEST_REFUSED,
               "position2d.req.get_geom of position2d:0 was refused");
  std::size_t size = 0;
  ph_client_refusal(client.get(), &size);
  EXPECT_EQ(size, geom().size());
  EXPECT_WORKS(ph_position2d_geometry(robot, &geometry, &error));
}

/// Answers a number of requests after the last of them, with the numbers 1, 2 and so on; `numbered`: with the
/// number of the request.
FakeServer::Script late(std::size_t wanted, bool numbered) {
  auto held = std::make_shared<std::vector<Received>>();
  return script([=](Peer &peer, const Received &message) {
    held->push_back(message);
    if (held->size() != wanted) return true;
    std::int32_t number = 0;
    for (Received request : *held) {
      if (!numbered) request.header.sequence = 0;
      peer.answer(request, body(ph_common_intprop_req_type, ph_common_intprop_req{"x", 2, ++number}));
    }
    return true;
  });
}

TEST(Asking, ALateAnswerIsNotTakenForAnothers) {
  for (const std::size_t late_ones : {1, 2}) {
    for (const bool numbered : {true, false}) {
      FakeServer server(late(late_ones + 1, numbered));
      const Client client = connected(server.address());
      ph_device *lamps = any(client, "dio");
      const ph_common_intprop_req question = {"x", 2, 0};
      std::int32_t value = 0;
      for (std::size_t i = 0; i < late_ones; ++i) {
        EXPECT_FAILS(ph_device_request(lamps, PH_COMMON_REQ_GET_INTPROP, &question, 0.02, nullptr, &error),
                     PH_REQUEST_TIMEOUT, "no answer to universal.req.get_intprop of dio:0 in 0.02 s");
      }
      EXPECT_WORKS(ph_device_get_int(lamps, "x", &value, &error));
      EXPECT_EQ(value, static_cast<std::int32_t>(late_ones) + 1);
      EXPECT_EQ(ph_client_skipped_count(client.get()), late_ones);
    }
  }
}

TEST(Asking, AnAnswerThatDoesNotDecodeNamesTheFault) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    peer.answer(message, {1, 2, 3, 4});
    return true;
  }));
  const Client client = connected(server.address());
  ph_geometry geometry;
  EXPECT_FAILS(ph_position2d_geometry(base(client), &geometry, &error), PH_WIRE_ERROR,
               "position2d.Geom: byte 0: 8 bytes expected, 4 are left");
}

TEST(Asking, AServerThatGoesIsNoticed) {
  FakeServer server(script([](Peer &, const Received &) { return false; }));
  const Client client = connected(server.address());
  ph_position2d *robot = base(client);
  ph_geometry geometry;
  EXPECT_FAILS(ph_position2d_geometry(robot, &geometry, &error), PH_RUN_ENDED,
               "the run ended: the server closed the connection");
  EXPECT_FALSE(ph_client_connected(client.get()));
  EXPECT_FAILS(ph_position2d_drive(robot, 1.0, 0.0, 0.0, &error), PH_RUN_ENDED, "the run ended");
}

TEST(Asking, PropertiesAreTypedAndTheirErrorsNameThem) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    const bool known = message.header.subtype == PH_COMMON_REQ_GET_STRPROP->subtype ||
                       message.header.subtype == PH_COMMON_REQ_GET_BOOLPROP->subtype;
    if (message.header.subtype == PH_COMMON_REQ_GET_BOOLPROP->subtype) {
      peer.answer(message, body(ph_common_boolprop_req_type, ph_common_boolprop_req{"k", 2, 2}));
    } else {
      peer.answer(message,
                  known ? body(ph_common_strprop_req_type, ph_common_strprop_req{"k", 2, "v", 2}) : Bytes(),
                  known ? PH_KIND_ACK : PH_KIND_NACK);
    }
    return true;
  }));
  const Client client = connected(server.address(), PH_MODE_PUSH);
  ph_device *lamps = any(client, "dio");
  const char *text = nullptr;
  bool yes = false;
  std::int32_t whole = 5;
  double number = 0;
  EXPECT_WORKS(ph_device_get_string(lamps, "k", &text, &error));
  EXPECT_STREQ(text, "v");
  EXPECT_WORKS(ph_device_get_bool(lamps, "k", &yes, &error));
  EXPECT_TRUE(yes);
  EXPECT_FAILS(ph_device_get_int(lamps, "lamp", &whole, &error), PH_REQUEST_REFUSED,
               "dio:0 has no int property \"lamp\"");
  EXPECT_EQ(whole, 5) << "left as it was";
  EXPECT_FAILS(ph_device_get_double(lamps, "lamp", &number, &error), PH_REQUEST_REFUSED, "no float property");
  EXPECT_FAILS(ph_device_set_int(lamps, "lamp", 7, &error), PH_REQUEST_REFUSED,
               "dio:0 refuses 7 as \"lamp\"");
  EXPECT_FAILS(ph_device_set_bool(lamps, "lamp", true, &error), PH_REQUEST_REFUSED, "refuses True as");
  EXPECT_FAILS(ph_device_set_double(lamps, "lamp", 0.25, &error), PH_REQUEST_REFUSED, "refuses 0.25 as");
  EXPECT_FAILS(ph_device_set_string(lamps, "lamp", "on", &error), PH_REQUEST_REFUSED, "refuses 'on' as");
  ph_error untouched = {PH_OK, "as before"};
  EXPECT_EQ(ph_device_has_capability(lamps, PH_POSITION2D_CMD_VEL, &yes, &untouched), PH_OK);
  EXPECT_FALSE(yes);
  EXPECT_STREQ(untouched.text, "as before");
}

TEST(Asking, ValuesThatMeanNothingAreNotSent) {
  FakeServer server(script([](Peer &, const Received &message) {
    ADD_FAILURE() << "this was sent: " << static_cast<int>(message.header.subtype);
    return true;
  }));
  const Client client = connected(server.address(), PH_MODE_PUSH);
  ph_position2d *robot = base(client);
  ph_simulation *simulation = ph_simulation_open(client.get(), 0, PH_ACCESS_ALL, nullptr);
  ph_fiducial *finder = ph_fiducial_open(client.get(), 0, PH_ACCESS_ALL, nullptr);
  ph_ptz *mount = ph_ptz_open(client.get(), 0, PH_ACCESS_ALL, nullptr);
  EXPECT_FAILS(ph_position2d_drive(robot, kNan, 0, 0, &error), PH_INVALID_VALUE,
               "position2d:0: vx is nan, not a finite number");
  EXPECT_FAILS(ph_position2d_drive(robot, 0, kInf, 0, &error), PH_INVALID_VALUE, "va is inf");
  EXPECT_FAILS(ph_position2d_drive(robot, 0, 0, -kInf, &error), PH_INVALID_VALUE, "vy is -inf");
  EXPECT_FAILS(ph_position2d_drive_car(robot, 0.1, kNan, &error), PH_INVALID_VALUE, "steering is nan");
  EXPECT_FAILS(ph_position2d_go_to(robot, {kNan, 0, 0}, 0, &error), PH_INVALID_VALUE, "x is nan");
  EXPECT_FAILS(ph_position2d_set_odometry(robot, {0, 0, kNan}, &error), PH_INVALID_VALUE, "a is nan");
  EXPECT_FAILS(ph_simulation_set_pose(simulation, "r0", {0, kNan, 0}, &error), PH_INVALID_VALUE, "y is nan");
  EXPECT_FAILS(ph_simulation_set_pose3d(simulation, "r0", {0, 0, 0, 0, 0, kNan}, &error), PH_INVALID_VALUE,
               "yaw is nan");
  EXPECT_FAILS(ph_fiducial_set_field_of_view(finder, 0, kInf, 1, &error), PH_INVALID_VALUE,
               "max_range is inf");
  EXPECT_FAILS(ph_ptz_look(mount, 1e300, 0, 0, &error), PH_WIRE_ERROR, "1e+300 is too large for the wire");
  for (const std::int64_t ticks : {std::int64_t{0}, std::int64_t{-1}, std::int64_t{1 << 20} + 1}) {
    EXPECT_FAILS(
        ph_simulation_step(simulation, ticks, kInf, &error), PH_INVALID_VALUE,
        "simulation:0: ticks is " + std::to_string(ticks) + ", not a whole number from 1 to 1048576");
  }
  for (const int index : {-1, 65536}) {
    EXPECT_REFUSES(ph_position2d_open(client.get(), index, PH_ACCESS_ALL, &error), PH_INVALID_VALUE,
                   "there is no position2d:" + std::to_string(index) + ": indices are 0 to 65535");
  }
  for (const double timeout : {-2.0, kNan}) {
    EXPECT_FAILS(ph_client_read(client.get(), timeout, nullptr, &error), PH_INVALID_VALUE,
                 "invalid time-out of");
  }
  EXPECT_REFUSES(ph_device_open(client.get(), "lazer", 0, PH_ACCESS_ALL, &error), PH_INVALID_VALUE,
                 "there is no interface \"lazer\" (did you mean \"laser\"?)");
  EXPECT_REFUSES(ph_device_open(client.get(), "xyzzy", 0, PH_ACCESS_ALL, &error), PH_INVALID_VALUE,
                 "there is no interface \"xyzzy\"");
}

TEST(Asking, ATimeOutMayBeInfinite) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    peer.answer(message);
    peer.position(1.0);
    peer.synch();
    return true;
  }));
  const Client client = connected(server.address(), PH_MODE_PULL, kInf);
  EXPECT_WORKS(ph_position2d_next_data(base(client), PH_OWN_TIMEOUT, &error));
  EXPECT_WORKS(ph_client_read(client.get(), kInf, nullptr, &error));
}

TEST(Asking, AClosedDeviceSaysSo) {
  FakeServer server(quiet());
  const Client client = connected(server.address());
  ph_position2d *robot = base(client), *other = base(client, 1);
  ph_geometry geometry;
  EXPECT_WORKS(ph_position2d_close(robot, &error));
  EXPECT_WORKS(ph_position2d_close(robot, &error));
  ph_client_close(client.get());
  for (ph_position2d *closed : {robot, other}) {
    const std::string wanted = std::string(ph_device_name(ph_position2d_device(closed))) + " is closed";
    EXPECT_FALSE(ph_device_is_open(ph_position2d_device(closed)));
    EXPECT_FAILS(ph_position2d_drive(closed, 0.1, 0, 0, &error), PH_DEVICE_CLOSED, wanted);
    EXPECT_FAILS(ph_position2d_geometry(closed, &geometry, &error), PH_DEVICE_CLOSED, wanted);
    EXPECT_FAILS(ph_position2d_next_data(closed, PH_OWN_TIMEOUT, &error), PH_DEVICE_CLOSED, wanted);
  }
  EXPECT_FAILS(ph_client_read(client.get(), PH_OWN_TIMEOUT, nullptr, &error), PH_CONNECTION_LOST,
               "the connection is closed");
  EXPECT_REFUSES(ph_position2d_open(client.get(), 0, PH_ACCESS_ALL, &error), PH_CONNECTION_LOST,
                 "the connection is closed");
}

TEST(Asking, ADeviceThatIsNotThereOrDoesNotStartCannotBeOpened) {
  for (const bool there : {false, true}) {
    FakeServer server([=](Peer &peer) {
      while (const auto message = peer.receive()) {
        const bool opens = message->header.subtype == PH_PLAYER_REQ_DEV->subtype;
        const ph_player_device_req failed = {{0, 0, 4, 0}, PH_PLAYER_ERROR_MODE, "", 1};
        peer.answer(*message, opens && there ? body(ph_player_device_req_type, failed) : Bytes(),
                    opens && !there ? PH_KIND_NACK : PH_KIND_ACK);
      }
    });
    const Client client = connected(server.address());
    EXPECT_REFUSES(ph_position2d_open(client.get(), 3, PH_ACCESS_ALL, &error), PH_REQUEST_REFUSED,
                   there ? "cannot open position2d:3" : "there is no position2d:3 to open");
  }
}

TEST(Asking, ADeviceIsTheProxyOfItsInterface) {
  FakeServer server(quiet());
  const Client client = connected(server.address());
  ph_device *laser = any(client, "laser");
  EXPECT_NE(ph_laser_of(laser, nullptr), nullptr);
  EXPECT_REFUSES(ph_position2d_of(laser, &error), PH_INVALID_VALUE, "laser:0 is not of interface position2d");
}

// --- the end: a server that ends has often just said the last things; they are delivered before the error

struct Seen {
  std::vector<double> x;
  std::size_t counted = 0;
  std::uint64_t overflow = 0;
};

Seen read_to_the_end(ph_mode mode, const std::function<void(Peer &, const Received &)> &end) {
  FakeServer server(script([&](Peer &peer, const Received &message) {
    end(peer, message);
    return false;
  }));
  const Client client = connected(server.address(), mode);
  ph_position2d *robot = base(client);
  Seen seen;
  ph_device_on_data(
      ph_position2d_device(robot),
      [](void *context, const ph_value *value) {
        static_cast<Seen *>(context)->x.push_back(
            static_cast<const ph_position2d_data *>(value->data)->pos.px);
      },
      &seen);
  if (mode == PH_MODE_PUSH) {
    EXPECT_WORKS(ph_position2d_drive(robot, 0.1, 0, 0, &error));  // anything, for the script to go on
  }
  ph_error error = {PH_OK, ""};
  for (std::size_t count = 0; ph_client_read(client.get(), PH_OWN_TIMEOUT, &count, &error) == PH_OK;)
    seen.counted += count;
  EXPECT_THAT(std::string(error.text), HasSubstr("the server closed the connection"));
  EXPECT_EQ(error.status, PH_RUN_ENDED);
  EXPECT_FAILS(ph_client_read(client.get(), PH_OWN_TIMEOUT, nullptr, &error), PH_RUN_ENDED,
               "closed the connection");
  EXPECT_FALSE(ph_client_connected(client.get()));
  seen.overflow = ph_client_overflow_count(client.get());
  return seen;
}

TEST(TheEnd, ARoundThatIsNeverClosedIsDelivered) {
  const Seen seen = read_to_the_end(PH_MODE_PULL, [](Peer &peer, const Received &message) {
    peer.answer(message);
    peer.position(1.0);
    peer.position(2.0);
  });
  EXPECT_THAT(seen.x, ElementsAre(1.0, 2.0));
  EXPECT_EQ(seen.counted, 2U);
}

TEST(TheEnd, DataInsteadOfAnAnswerAreDeliveredAndTheirLossesCounted) {
  const Seen seen = read_to_the_end(PH_MODE_PULL, [](Peer &peer, const Received &) {
    for (int x = 0; x < 3000; ++x) peer.position(x);  // more than wait for an ordinary request
    peer.overflow(551);
  });
  EXPECT_EQ(seen.x.size(), 3000U);
  EXPECT_EQ(seen.counted, 3000U);
  EXPECT_EQ(seen.overflow, 551U);
}

TEST(TheEnd, PushedDataAreDelivered) {
  const Seen seen = read_to_the_end(PH_MODE_PUSH, [](Peer &peer, const Received &) {
    peer.position(1.0);
    peer.position(2.0);
  });
  EXPECT_THAT(seen.x, ElementsAre(1.0, 2.0));
}

TEST(TheEnd, DataThatCameBeforeACommandFailedCanStillBeRead) {
  FakeServer server(script([](Peer &peer, const Received &) {
    peer.position(1.0);
    peer.reset();
    return false;  // what is sent there from now on is answered with a reset
  }));
  const Client client = connected(server.address(), PH_MODE_PUSH);
  ph_position2d *robot = base(client);
  ph_error error = {PH_OK, ""};
  while (ph_position2d_drive(robot, 0.1, 0, 0, &error) == PH_OK) {
  }
  EXPECT_THAT(std::string(error.text), HasSubstr("the server is gone"));
  EXPECT_EQ(read_one(client), 1U);
  EXPECT_EQ(x_of(robot), 1.0);
  EXPECT_FAILS(ph_client_read(client.get(), PH_OWN_TIMEOUT, nullptr, &error), PH_CONNECTION_LOST,
               "the server is gone");
}

// --- closing

/// The devices that were opened (+), commanded (!) and closed (-), in order.
std::vector<std::string> told(const std::vector<Received> &received) {
  std::vector<std::string> found;
  for (const Received &message : received) {
    if (message.header.kind == PH_KIND_CMD) {
      found.push_back("!" + std::to_string(message.header.interface_code) + ":" +
                      std::to_string(message.header.index));
    } else if (message.header.interface_code == 1 && message.header.subtype == PH_PLAYER_REQ_DEV->subtype) {
      ph_player_device_req request{};
      ph_arena arena = {nullptr};
      ph_player_device_req_decode(&request, message.body.data(), message.body.size(), &arena, nullptr);
      ph_arena_free(&arena);
      found.push_back((request.access == PH_PLAYER_CLOSE_MODE ? "-" : "+") +
                      std::to_string(request.addr.interf) + ":" + std::to_string(request.addr.index));
    }
  }
  return found;
}

TEST(Ending, AMovingRobotIsStoppedBeforeItsDeviceIsClosedInReverseOrder) {
  FakeServer server(quiet());
  {
    const Client client = connected(server.address());
    EXPECT_WORKS(ph_position2d_drive(base(client), 0.4, 0.1, 0, &error));
    any(client, "laser");
  }
  EXPECT_THAT(told(server.finish()), ElementsAre("+4:0", "!4:0", "+6:0", "-6:0", "!4:0", "-4:0"));
  const Received &last = server.finish()[server.finish().size() - 2];
  EXPECT_EQ(last.body, body(ph_position2d_cmd_vel_type, ph_position2d_cmd_vel{{0, 0, 0}, 1}));
}

TEST(Ending, ARobotThatStandsGetsNoFurtherCommand) {
  FakeServer server(quiet());
  {
    const Client client = connected(server.address());
    ph_position2d *robot = base(client);
    EXPECT_WORKS(ph_position2d_drive(robot, 0.4, 0, 0, &error));
    EXPECT_WORKS(ph_position2d_stop(robot, &error));
    ph_position2d_free(robot);
  }
  EXPECT_THAT(told(server.finish()), ElementsAre("+4:0", "!4:0", "!4:0", "-4:0"));
}

TEST(Ending, ReadingAccessIsAskedForByItsCharacter) {
  FakeServer server(quiet());
  {
    const Client client = connected(server.address());
    ph_position2d *robot = base(client, 0, PH_ACCESS_READ);
    EXPECT_EQ(ph_device_access(ph_position2d_device(robot)), PH_ACCESS_READ);
  }
  EXPECT_EQ(server.finish().at(1).body.at(19), 'r');
}

}  // namespace
}  // namespace playhouse_c
