#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "playhouse/net/io_loop.h"
#include "playhouse/net/simulated.h"

namespace playhouse::net {
namespace {

std::vector<std::byte> bytes_of(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}
std::string text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TEST(Endpoint, addresses_are_read_and_told_as_people_write_them) {
  EXPECT_EQ(to_text(*parse_endpoint("10.0.0.7", 42)), "10.0.0.7:42");
  EXPECT_EQ(to_text(*parse_endpoint("localhost", 1)), "127.0.0.1:1");
  EXPECT_EQ(to_text(*parse_endpoint("::1", 65535)), "[::1]:65535");
  EXPECT_TRUE(parse_endpoint("10.0.0.7", 1)->is_v4());
  EXPECT_FALSE(parse_endpoint("::1", 1)->is_v4());
  EXPECT_EQ(parse_endpoint("somewhere", 1).error().line(), "somewhere: is not an IPv4 or IPv6 address");
  EXPECT_EQ(*resolve("127.0.0.1", 7), *parse_endpoint("127.0.0.1", 7));
  for (const char* const group : {"224.0.0.1", "239.255.255.255"})
    EXPECT_TRUE(parse_endpoint(group, 1)->is_group()) << group;
  for (const char* const other : {"223.255.255.255", "240.0.0.1", "ff02::1"})
    EXPECT_FALSE(parse_endpoint(other, 1)->is_group()) << other;
}

/// Both ends in one loop.
void expect_an_echo(const std::string& bind) {
  IoLoop loop;
  std::unique_ptr<DatagramSocket> server, client;
  std::string heard;
  server = *loop.open_datagrams(bind, 0, [&](const Endpoint& from, std::span<const std::byte> bytes) {
    server->send(from, bytes_of(text_of(bytes) + ", " + std::to_string(from.port == client->port())));
  });
  client = *loop.open_datagrams(bind, 0, [&](const Endpoint&, std::span<const std::byte> bytes) {
    heard = text_of(bytes);
    loop.stop();
  });
  client->send(*parse_endpoint(bind == "::" ? "127.0.0.1" : bind, server->port()), bytes_of("hello"));
  const auto patience = loop.after(60, [&] { loop.stop(); });
  loop.run();
  EXPECT_EQ(heard, "hello, 1") << bind;
}

TEST(Datagrams, go_there_and_back_between_real_sockets) {
  expect_an_echo("127.0.0.1");
  expect_an_echo("::1");
  expect_an_echo("::");  // hears IPv4 as well
}

TEST(Datagrams, tell_of_a_peer_whose_port_is_closed_and_reach_the_others) {
  for (const char* const bind : {"127.0.0.1", "::1", "::"}) {
    IoLoop loop;
    const std::string host = std::string(bind) == "::" ? "127.0.0.1" : bind;
    std::vector<Endpoint> refused;
    std::string heard;
    const auto socket = *loop.open_datagrams(bind, 0, [](auto&&...) {});
    socket->on_refused([&](const Endpoint& peer) {
      refused.push_back(peer);
      loop.stop();
    });
    auto gone = *loop.open_datagrams(host, 0, [](auto&&...) {});
    const auto other = *loop.open_datagrams(host, 0, [&](const Endpoint&, std::span<const std::byte> bytes) {
      heard = text_of(bytes);
      loop.stop();
    });
    const Endpoint peer = *parse_endpoint(host, gone->port());
    gone.reset();
    EXPECT_TRUE(socket->send(peer, bytes_of("hello")));
    const auto patience = loop.after(60, [&] { loop.stop(); });
    loop.run();
    ASSERT_EQ(refused.size(), 1u) << bind;
    EXPECT_EQ(refused[0], peer) << to_text(refused[0]);
    socket->send(peer, bytes_of("hello"));
    EXPECT_TRUE(socket->send(*parse_endpoint(host, other->port()), bytes_of("hello")));
    while (heard.empty() && refused.size() < 3) loop.run();
    EXPECT_EQ(heard, "hello") << bind;
  }
}

TEST(Datagrams, answers_come_from_the_address_that_the_peer_spoke_to) {
  for (const char* const bind : {"0.0.0.0", "::"}) {
    IoLoop loop;
    std::unique_ptr<DatagramSocket> server;
    server = *loop.open_datagrams(
        bind, 0, [&](const Endpoint& from, std::span<const std::byte> bytes) { server->send(from, bytes); });
    for (const char* const ours : {"127.0.0.1", "127.0.0.2", "127.0.0.3"}) {
      Endpoint answered;
      const auto client = *loop.open_datagrams("127.0.0.1", 0, [&](const Endpoint& from, auto) {
        answered = from;
        loop.stop();
      });
      client->send(*parse_endpoint(ours, server->port()), bytes_of("hello"));
      const auto patience = loop.after(60, [&] { loop.stop(); });
      loop.run();
      EXPECT_EQ(to_text(answered), std::string(ours) + ":" + std::to_string(server->port())) << bind;
    }
  }
}

TEST(Datagrams, answers_to_an_address_that_is_no_more_come_from_another) {
  IoLoop loop;
  bool heard = false;
  const auto server = *loop.open_datagrams("0.0.0.0", 0, [](auto&&...) {});
  const auto client = *loop.open_datagrams("127.0.0.1", 0, [&](auto&&...) {
    heard = true;
    loop.stop();
  });
  Endpoint peer = *parse_endpoint("127.0.0.1", client->port());
  peer.spoken_to = parse_endpoint("192.0.2.1", 1)->address;
  EXPECT_TRUE(server->send(peer, bytes_of("hello")));
  const auto patience = loop.after(60, [&] { loop.stop(); });
  loop.run();
  EXPECT_TRUE(heard);
}

TEST(Datagrams, say_that_a_datagram_is_too_long) {
  IoLoop loop;
  const auto socket = *loop.open_datagrams("127.0.0.1", 0, [](auto&&...) {});
  const Endpoint peer = *parse_endpoint("127.0.0.1", socket->port());
  EXPECT_TRUE(socket->send(peer, std::vector<std::byte>(65507)));
  EXPECT_FALSE(socket->send(peer, std::vector<std::byte>(65508)));
}

TEST(Datagrams, a_socket_may_be_closed_by_what_it_hears) {
  IoLoop loop;
  std::unique_ptr<DatagramSocket> server;
  int heard = 0;
  server = *loop.open_datagrams("127.0.0.1", 0, [&](const Endpoint&, std::span<const std::byte>) {
    ++heard;
    server.reset();
    loop.stop();
  });
  const auto client = *loop.open_datagrams("127.0.0.1", 0, [](const Endpoint&, auto) {});
  const Endpoint there = *parse_endpoint("127.0.0.1", server->port());
  client->send(there, bytes_of("one"));
  client->send(there, bytes_of("two"));
  const auto patience = loop.after(60, [&] { loop.stop(); });
  loop.run();
  EXPECT_EQ(heard, 1);
}

TEST(Datagrams, a_port_that_is_taken_and_an_address_that_is_none_are_told) {
  IoLoop loop;
  const auto first = *loop.open_datagrams("127.0.0.1", 0, [](const Endpoint&, auto) {});
  const auto second = loop.open_datagrams("127.0.0.1", first->port(), [](const Endpoint&, auto) {});
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().line().find("cannot listen for datagrams: Address already in use"),
            std::string::npos);
  EXPECT_FALSE(loop.open_datagrams("nowhere", 0, [](const Endpoint&, auto) {}));
}

/// Sends the numbers from 0 on, one a millisecond, and returns what comes in the order in which it comes.
std::vector<int> carried(DatagramFaults faults, std::uint64_t seed, int count = 1000) {
  SimulatedNetwork network(seed);
  network.datagrams = faults;
  std::vector<int> heard;
  const auto server =
      *network.open_datagrams("10.0.0.1", 5, [&](const Endpoint& from, std::span<const std::byte> bytes) {
        EXPECT_EQ(to_text(from), "10.0.0.2:6");
        heard.push_back(std::stoi(text_of(bytes)));
      });
  const auto client = *network.open_datagrams("10.0.0.2", 6, [](const Endpoint&, auto) {});
  for (int k = 0; k < count; ++k) {
    client->send(*parse_endpoint("10.0.0.1", 5), bytes_of(std::to_string(k)));
    client->send(*parse_endpoint("10.0.0.9", 5), bytes_of("nobody is there"));
    network.run_for(0.001);
  }
  network.run_for(10);
  return heard;
}

TEST(SimulatedDatagrams, without_faults_each_comes_once_and_in_order) {
  const std::vector<int> heard = carried({}, 1);
  EXPECT_EQ(heard.size(), 1000u);
  EXPECT_TRUE(std::ranges::is_sorted(heard));
}

TEST(SimulatedDatagrams, are_lost_doubled_and_overtaken_as_often_as_the_network_is_told) {
  const std::vector<int> lost = carried({.loss = 0.3}, 2);
  EXPECT_NEAR(static_cast<double>(lost.size()), 700, 60);
  const std::vector<int> doubled = carried({.duplication = 0.2}, 3);
  EXPECT_NEAR(static_cast<double>(doubled.size()), 1200, 60);
  EXPECT_EQ(std::set(doubled.begin(), doubled.end()).size(), 1000u);
  const std::vector<int> late = carried({.jitter = 0.005}, 4);
  EXPECT_EQ(late.size(), 1000u);
  EXPECT_FALSE(std::ranges::is_sorted(late));
}

TEST(SimulatedDatagrams, the_same_seed_is_the_same_network) {
  const DatagramFaults faults{.loss = 0.3, .duplication = 0.2, .jitter = 0.01};
  EXPECT_EQ(carried(faults, 5), carried(faults, 5));
  EXPECT_NE(carried(faults, 5), carried(faults, 6));
}

}  // namespace
}  // namespace playhouse::net
