#include "playhouse/net/polled/simulated_machines.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace playhouse::net {
namespace {

constexpr double kForEver = std::numeric_limits<double>::infinity();

std::span<const std::byte> bytes(std::string_view text) {
  return std::as_bytes(std::span(text));
}

/// All of it, waiting for room. False: the peer is gone.
bool say(PolledNetwork& network, PolledStream& stream, std::string_view text) {
  for (auto left = bytes(text); !left.empty();) {
    const Result<std::size_t> sent = stream.send({&left, 1});
    if (!sent) return false;
    left = left.subspan(*sent);
    const PollWish wish{&stream, false, true};
    if (!left.empty()) network.wait({&wish, 1}, nullptr, kForEver);
  }
  return true;
}

/// Until so many bytes have come, or the peer is gone.
std::string hear(PolledNetwork& network, PolledStream& stream, std::size_t count, double until = kForEver) {
  std::string heard;
  std::vector<std::byte> some(1000);
  while (heard.size() < count) {
    const Result<std::size_t> got = stream.receive(some);
    if (!got) return heard + "|" + got.error().text;
    heard.append(reinterpret_cast<const char*>(some.data()), *got);
    const PollWish wish{&stream, true, false};
    if (heard.size() < count && !network.wait({&wish, 1}, nullptr, until)) return heard + "|late";
  }
  return heard;
}

std::unique_ptr<PolledStream> accepted(PolledNetwork& network, PolledListener& listener) {
  EXPECT_TRUE(network.wait({}, &listener, kForEver));
  return listener.accept();
}

TEST(SimulatedMachines, talk_in_virtual_time_and_hear_the_end) {
  SimulatedMachines network(1);
  network.delay = 0.1;
  const auto listener = *network.listen("10.2.0.0", 0);
  const std::string longer(200000, 'x');  // than there is room
  std::string heard;
  const std::size_t machine = network.begin([&] {
    const auto stream = *network.connect("head", listener->port(), 1);
    EXPECT_TRUE(say(network, *stream, longer));
    heard = hear(network, *stream, 6);
  });
  auto stream = accepted(network, *listener);
  EXPECT_EQ(hear(network, *stream, longer.size()), longer);
  EXPECT_GT(network.now(), 0.3);  // four windows
  EXPECT_LT(network.now(), 1);
  EXPECT_TRUE(say(network, *stream, "thanks"));
  EXPECT_EQ(hear(network, *stream, 1), "|closed the connection");
  EXPECT_TRUE(network.has_ended(machine));
  EXPECT_EQ(heard, "thanks");
}

TEST(SimulatedMachines, that_crash_are_silent_for_others_and_end) {
  SimulatedMachines network(1);
  const auto listener = *network.listen("10.2.0.0", 7);
  std::string heard;
  const std::size_t machine = network.begin([&] {
    const auto stream = *network.connect("head", 7, 1);
    say(network, *stream, "hello");
    heard = hear(network, *stream, 5);
  });
  const auto stream = accepted(network, *listener);
  EXPECT_EQ(hear(network, *stream, 5), "hello");
  network.crash(machine);
  EXPECT_TRUE(say(network, *stream, "hello"));
  EXPECT_EQ(hear(network, *stream, 1, network.now() + 2), "|late");
  EXPECT_TRUE(network.has_ended(machine));
  EXPECT_EQ(heard, "|has crashed");
}

TEST(SimulatedMachines, hear_after_a_cut_what_was_said_meanwhile) {
  SimulatedMachines network(1);
  const auto listener = *network.listen("10.2.0.0", 7);
  std::string heard;
  network.begin([&] {
    const auto stream = *network.connect("head", 7, 1);
    heard = hear(network, *stream, 5);
  });
  const auto stream = accepted(network, *listener);
  network.cut(3);
  EXPECT_TRUE(say(network, *stream, "hello"));
  network.pass(2.9);
  EXPECT_EQ(heard, "");
  network.pass(0.2);
  EXPECT_EQ(heard, "hello");
  EXPECT_EQ((*network.connect("head", 7, 1))->peer(), "head:7");
  EXPECT_EQ(network.connect("head", 8, 1).error().text, "Connection refused");
}

}  // namespace
}  // namespace playhouse::net
