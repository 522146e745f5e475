// One driver uses the devices of others.

#include "playhouse/device/client.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "playhouse/device/fake_device.h"

namespace playhouse::device {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr DeviceId kWheels{3}, kLaser{5};

class ClientTest : public ::testing::Test {
 protected:
  ClientTest() {
    client.use(0, kWheels, wheels());
    client.use(1, kLaser, laser());
    client.join(flow);
    flow.pass_to(out);
  }
  FakeDevice& wheels() { return devices.drivers[kWheels.row]; }
  FakeDevice& laser() { return devices.drivers[kLaser.row]; }
  void publish(DeviceId device, std::uint8_t subtype, std::string_view body) {
    flow.publish({{device, subtype, 0, bytes(body)}});
  }

  FakeDevices devices;
  FakeDevice owner;
  FakePublisher out;
  FakeOutlet outlet;
  DataFlow flow;
  DeviceClient client{devices, owner, 2};
};

TEST_F(ClientTest, holds_its_devices_while_it_is_open) {
  ASSERT_TRUE(client.open());
  EXPECT_EQ(devices.held[kWheels.row] + devices.held[kLaser.row], 2);
  client.close();
  client.close();  // when its owner heard that a device retired, and then has to stop
  EXPECT_EQ(devices.held[kWheels.row] + devices.held[kLaser.row], 0);
}

TEST_F(ClientTest, holds_its_devices_for_its_owner_who_hears_when_they_retire) {
  ASSERT_TRUE(client.open());
  EXPECT_EQ(devices.holders[kWheels.row], &owner);
  EXPECT_EQ(devices.holders[kLaser.row], &owner);
}

TEST_F(ClientTest, a_device_of_two_numbers_is_held_and_read_once) {
  DeviceClient twice{devices, owner, 2};
  Subscription& first = twice.queue(0, 4);
  Subscription& second = twice.queue(1, 4);
  for (const std::size_t number : {0, 1}) twice.use(number, kWheels, wheels());
  twice.join(flow);
  ASSERT_TRUE(twice.open());
  EXPECT_EQ(devices.held[kWheels.row], 1);
  publish(kWheels, 1, "here");
  EXPECT_EQ(first.take().size(), 1u);
  EXPECT_EQ(second.take().size(), 1u);
  twice.close();
  EXPECT_EQ(devices.held[kWheels.row], 0);
}

TEST_F(ClientTest, opens_none_when_one_cannot_start) {
  laser().broken = true;
  const Result<void> opened = client.open();
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().text, "no hardware");
  EXPECT_EQ(devices.held[kWheels.row], 0);
  EXPECT_EQ(client.command(0, 1, bytes("go")), Taken::kNo) << "it is closed";
}

TEST_F(ClientTest, data_come_while_it_is_open_and_news_may_join_them) {
  Subscription& states = client.queue(0, 8);
  Subscription& scan = client.latest(1, 1);
  int news = 0;
  client.when_news([&](std::vector<Publication>& more) {
    ++news;
    more.push_back({DeviceId{9}, 1, 0, bytes("made")});
  });
  publish(kWheels, 1, "early");
  ASSERT_TRUE(client.open());
  publish(kWheels, 1, "a");
  publish(kWheels, 2, "b");
  publish(kLaser, 1, "scan");
  client.close();
  publish(kWheels, 1, "late");
  EXPECT_EQ(news, 3);
  EXPECT_EQ(states.take().size(), 2u);
  EXPECT_EQ(text(scan.take_latest()->body), "scan");
  EXPECT_THAT(out.lines, ElementsAre("3.1 early", "3.1 a", "9.1 made", "3.2 b", "9.1 made", "5.1 scan",
                                     "9.1 made", "3.1 late"));
}

TEST_F(ClientTest, opened_again_it_begins_with_nothing) {
  Subscription& states = client.queue(0, 8);
  ASSERT_TRUE(client.open());
  publish(kWheels, 1, "a");
  client.close();
  ASSERT_TRUE(client.open());
  EXPECT_THAT(states.take(), IsEmpty());
}

TEST_F(ClientTest, commands_reach_the_device_that_is_meant) {
  ASSERT_TRUE(client.open());
  EXPECT_EQ(client.command(0, 1, bytes("go")), Taken::kQueued) << "what the driver said";
  EXPECT_THAT(wheels().commands, ElementsAre("go"));
  EXPECT_THAT(laser().commands, IsEmpty());
}

TEST_F(ClientTest, hears_each_answer_once_and_a_refusal_as_nothing) {
  std::vector<std::string> heard;
  const DeviceClient::Heard hear = [&](const std::optional<std::vector<std::byte>>& body) {
    heard.push_back(body ? text(*body) : "nothing");
  };
  client.ask(0, 1, bytes("size?"), hear);
  client.ask(1, 9, bytes("?"), hear);
  EXPECT_THAT(heard, ElementsAre("size?", "nothing"));
}

TEST_F(ClientTest, whose_request_it_forwards_gets_the_answer) {
  client.forward(0, 1, bytes("size?"), Replier(outlet, 7));
  client.forward(0, 9, bytes("?"), Replier(outlet, 8));
  EXPECT_EQ(outlet.answers[7], "size?");
  EXPECT_EQ(outlet.answers[8], "NACK");
  EXPECT_TRUE(client.capable(0, 3, 1));
  EXPECT_FALSE(client.capable(0, 3, 9));
}

TEST_F(ClientTest, its_barrier_is_the_last_of_its_devices) {
  client.barrier(Replier(outlet, 1));
  laser().barriers.clear();  // a driver that ends lets go of its repliers
  EXPECT_TRUE(outlet.answers.empty());
  wheels().barriers[0].ack();
  EXPECT_EQ(outlet.answers[1], "");
}

// For the thread sanitizer: the io thread opens and closes, one thread publishes, one thread uses the
// devices.
TEST_F(ClientTest, any_thread_may_use_it) {
  constexpr int kRounds = 2000;
  Subscription& states = client.queue(0, 4);
  std::atomic<int> heard = 0;
  std::atomic<bool> over = false;
  std::uint64_t published = 0, taken = 0;
  ASSERT_TRUE(client.open());
  std::thread publisher([&] {
    for (int i = 0; i < kRounds; ++i) publish(kWheels, 1, "a"), ++published;
    over = true;
  });
  std::thread user([&] {
    while (!over) {
      taken += states.take().size();
      client.command(0, 1, {});
      client.ask(1, 1, {}, [&](const std::optional<std::vector<std::byte>>&) { ++heard; });
    }
  });
  for (int i = 0; i < kRounds; ++i)
    client.ask(1, 1, {}, [&](const std::optional<std::vector<std::byte>>&) { ++heard; });
  publisher.join();
  user.join();
  taken += states.take().size();
  EXPECT_EQ(taken + states.lost(), published);
  EXPECT_GE(heard, kRounds);
}

}  // namespace
}  // namespace playhouse::device
