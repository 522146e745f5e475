// What a program in C++ sees of devices that the real server retires.

#include <gtest/gtest.h>

#include "playhouse_client/client.h"
#include "playhouse_client/position2d.h"
#include "retiring_server.h"

namespace playhouse::client {
namespace {

constexpr Seconds kLong{30};  // an answer is not waited for: it comes, or something hangs

class RetiredDevice : public ::testing::TestWithParam<Mode> {
 protected:
  RetiredDevice() : client(*Client::connect(server.address(), {.mode = GetParam(), .timeout = kLong})) {
    server.add(0);
    server.add(3);
  }
  Position2d open(std::uint16_t index) { return *Position2d::open(client, index); }
  std::string why() const {
    return std::to_string(server.port()) + ":position2d:3 is gone: the server retired it";
  }

  RetiringServer server;
  Client client;
};

TEST_P(RetiredDevice, gives_its_last_data_and_fails_at_once_from_then_on) {
  Position2d gone = open(3), other = open(0);
  server.publish(3, 1);
  server.retire(3);
  server.publish(0, 2);
  while (!gone.device().gone() || !other.state()) ASSERT_TRUE(client.read());
  EXPECT_EQ(gone.state()->pose.x, 1);
  EXPECT_EQ(gone.drive(1, 0).error().line(), why());
  EXPECT_EQ(gone.geometry().error().line(), why());
  EXPECT_EQ(gone.device().ask<wire::position2d::Geom>(wire::position2d::kReqGetGeom).error().line(), why());
  EXPECT_TRUE(gone.close());
  EXPECT_FALSE(gone.device().gone());
  EXPECT_TRUE(other.geometry());
  EXPECT_EQ(server.commands(), 0u);
}

TEST_P(RetiredDevice, ends_a_read_that_waits_for_nothing_else) {
  Position2d gone = open(3);
  server.retire(3);
  EXPECT_EQ(*client.read(), 0u);
  EXPECT_TRUE(gone.device().gone());
  EXPECT_TRUE(client.connected());
}

TEST_P(RetiredDevice, leaves_its_address_to_another_and_does_not_become_it) {
  Position2d gone = open(3);
  server.publish(3, 1);
  server.retire(3);
  server.add(3);
  Position2d next = open(3);
  EXPECT_TRUE(gone.device().gone());
  server.publish(3, 2);
  while (!next.state()) ASSERT_TRUE(client.read());
  EXPECT_EQ(next.state()->pose.x, 2);
  EXPECT_FALSE(next.device().gone());
  EXPECT_FALSE(gone.state() && gone.state()->pose.x == 2);
  EXPECT_TRUE(gone.close());
  EXPECT_TRUE(next.geometry());
}

TEST_P(RetiredDevice, that_was_driving_needs_no_stop) {
  {
    Position2d gone = open(3);
    ASSERT_TRUE(gone.drive(1, 0));
    ASSERT_TRUE(gone.geometry());  // the command has arrived
    server.retire(3);
    ASSERT_TRUE(client.read());
  }
  EXPECT_EQ(server.commands(), 1u);
}

INSTANTIATE_TEST_SUITE_P(InBothModes, RetiredDevice, ::testing::Values(Mode::kPush, Mode::kPull),
                         [](const auto& mode) { return mode.param == Mode::kPush ? "push" : "pull"; });

}  // namespace
}  // namespace playhouse::client
