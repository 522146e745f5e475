#include <gtest/gtest.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <map>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/net/asio_loop.h"
#include "playhouse/net/io_loop.h"
#include "playhouse/net/simulated.h"
#include "playhouse/net/testing_bytes.h"

namespace playhouse::net {
namespace {

/// Keeps what a connection tells it.
struct Log final : ConnectionEvents {
  std::unique_ptr<Connection> connection;
  std::string bytes, end;
  int drains = 0, losses = 0;
  std::function<void()> on_received = [] {};
  void received(std::span<const std::byte> part) override {
    bytes += text(part);
    on_received();
  }
  void drained() override { ++drains; }
  void lost() override { ++losses; }
  void closed(const std::string& why) override { end = why; }
};

Network::Acceptor into(Log& log) {
  return [&log](std::unique_ptr<Connection> connection) {
    log.connection = std::move(connection);
    log.connection->start(log);
  };
}

/// A blocking client socket of the test.
class Client {
 public:
  Client(std::uint16_t port, int family = AF_INET) : descriptor_(socket(family, SOCK_STREAM, 0)) {
    sockaddr_in6 v6{};
    v6.sin6_family = AF_INET6;
    v6.sin6_port = htons(port);
    v6.sin6_addr = in6addr_loopback;
    sockaddr_in v4{};
    v4.sin_family = AF_INET;
    v4.sin_port = htons(port);
    v4.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const bool six = family == AF_INET6;
    connected =
        ::connect(descriptor_, six ? reinterpret_cast<sockaddr*>(&v6) : reinterpret_cast<sockaddr*>(&v4),
                  six ? sizeof v6 : sizeof v4) == 0;
  }
  ~Client() { close(descriptor_); }
  void send(std::string_view text) {
    ASSERT_EQ(::send(descriptor_, text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
  }
  void send_urgent(char letter) { ASSERT_EQ(::send(descriptor_, &letter, 1, MSG_OOB), 1); }
  void finish() { shutdown(descriptor_, SHUT_WR); }
  /// Closes so that the other side sees a reset.
  void reset() {
    const linger hard{1, 0};
    setsockopt(descriptor_, SOL_SOCKET, SO_LINGER, &hard, sizeof hard);
    close(std::exchange(descriptor_, -1));
  }
  std::string read(std::size_t count) { return read(count, MSG_WAITALL); }
  /// What has come.
  std::string read_now(std::size_t most) { return read(most, MSG_DONTWAIT); }
  bool connected = false;

 private:
  std::string read(std::size_t count, int flags) {
    std::string result(count, 0);
    result.resize(
        static_cast<std::size_t>(std::max<ssize_t>(0, recv(descriptor_, result.data(), count, flags))));
    return result;
  }

  int descriptor_;
};

/// Serves the loop until the condition holds; gives up after five seconds so that a fault is a failure, not a
/// hang.
template <typename Condition>
::testing::AssertionResult serve_until(IoLoop& loop, Condition done) {
  for (int i = 0; i < 5000 && !done(); ++i) {
    auto timer = loop.after(0.001, [&loop] { loop.stop(); });
    loop.run();
  }
  return done() ? ::testing::AssertionSuccess() : ::testing::AssertionFailure() << "did not happen in 5 s";
}

/// A client whose connection was accepted.
class AcceptedTcp : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(serve_until(loop, [this] { return log.connection != nullptr; }));
  }

  IoLoop loop;
  Log log;
  Result<std::unique_ptr<Listener>> listener = loop.listen("127.0.0.1", 0, into(log));
  Client client{(*listener)->port()};
};

TEST(IoLoop, runs_posted_tasks_in_the_order_of_the_calls) {
  IoLoop loop;
  std::string order;
  loop.post([&] { order += "a"; });
  loop.post([&] { order += "b"; });
  loop.post([&] { loop.stop(); });
  loop.run();
  EXPECT_EQ(order, "ab");
}

TEST(IoLoop, takes_posts_and_stop_from_another_thread) {
  IoLoop loop;
  int calls = 0;
  std::thread other([&] {
    for (int i = 0; i < 100; ++i) loop.post([&] { ++calls; });
    loop.stop();
  });
  loop.run();
  other.join();
  EXPECT_EQ(calls, 100);
}

TEST(IoLoop, does_not_run_a_timer_whose_handle_is_gone) {
  IoLoop loop;
  bool early = false, late = false;
  auto gone = loop.after(0.0, [&] { early = true; });
  gone.reset();
  auto kept = loop.after(0.002, [&] {
    late = true;
    loop.stop();
  });
  loop.run();
  EXPECT_FALSE(early);
  EXPECT_TRUE(late);
}

TEST(Tcp, carries_bytes_both_ways_and_says_when_they_are_out) {
  IoLoop loop;
  Log log;
  auto listener = loop.listen("127.0.0.1", 0, into(log));
  ASSERT_TRUE(listener) << listener.error().line();
  Client client((*listener)->port());
  client.send("hello");
  ASSERT_TRUE(serve_until(loop, [&] { return log.bytes == "hello"; }));
  log.connection->send(std::vector{shared("one "), shared("two")});
  ASSERT_TRUE(serve_until(loop, [&] { return log.drains == 1; }));
  EXPECT_EQ(log.connection->in_flight_bytes(), 0u);
  EXPECT_EQ(client.read(7), "one two");
}

// A loop that is busy would come back to the rest after everything else, however many parts that is.
TEST(Tcp, hands_all_parts_to_the_system_at_once) {
  IoLoop loop;
  Log log;
  const auto listener = loop.listen("127.0.0.1", 0, into(log));
  Client client((*listener)->port());
  ASSERT_TRUE(serve_until(loop, [&] { return log.connection != nullptr; }));
  const std::vector<SharedBytes> parts(1000, shared("abcdefg"));
  log.connection->send(parts);
  EXPECT_EQ(client.read_now(7001).size(), 7000u);
  EXPECT_EQ(log.drains, 0) << "events come from the loop";
  ASSERT_TRUE(serve_until(loop, [&] { return log.drains == 1; }));
}

TEST(Tcp, serves_ipv6_and_ipv4_at_the_any_address) {
  IoLoop loop;
  Log log;
  auto listener = loop.listen("::", 0, into(log));
  if (!listener) GTEST_SKIP() << "no IPv6 on this machine: " << listener.error().line();
  Client six((*listener)->port(), AF_INET6);
  ASSERT_TRUE(six.connected);
  ASSERT_TRUE(serve_until(loop, [&] { return log.connection != nullptr; }));
  EXPECT_EQ(log.connection->peer().substr(0, 6), "[::1]:");
  Client four((*listener)->port());
  EXPECT_TRUE(four.connected);
}

TEST(Tcp, says_why_it_cannot_listen) {
  IoLoop loop;
  Log log;
  auto first = loop.listen("127.0.0.1", 0, into(log));
  ASSERT_TRUE(first);
  auto second = loop.listen("127.0.0.1", (*first)->port(), into(log));
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().line().find("Address already in use"), std::string::npos) << second.error().line();
  auto nonsense = loop.listen("nowhere", 0, into(log));
  ASSERT_FALSE(nonsense);
  EXPECT_EQ(nonsense.error().line(), "nowhere: is not an IPv4 or IPv6 address");
}

TEST(Tcp, delivers_what_was_sent_before_the_peer_closed) {
  IoLoop loop;
  Log log;
  auto listener = loop.listen("127.0.0.1", 0, into(log));
  {
    Client client((*listener)->port());
    client.send("last words");
  }
  ASSERT_TRUE(serve_until(loop, [&] { return !log.end.empty(); }));
  EXPECT_EQ(log.bytes, "last words");
  EXPECT_EQ(log.end, "closed");
  EXPECT_EQ(log.losses, 0);
}

TEST(Tcp, says_when_a_peer_that_finished_sending_has_read_everything_and_when_it_is_lost) {
  IoLoop loop;
  Log log;
  auto listener = loop.listen("127.0.0.1", 0, into(log));
  Client client((*listener)->port());
  client.finish();
  ASSERT_TRUE(serve_until(loop, [&] { return !log.end.empty(); }));
  log.connection->send(std::vector{shared("answer")});
  EXPECT_TRUE(serve_until(loop, [&] { return log.drains == 1; }));
  EXPECT_EQ(client.read(6), "answer");
  client.reset();
  EXPECT_TRUE(serve_until(loop, [&] {
    if (log.connection->in_flight_bytes() == 0) log.connection->send(std::vector{shared("more")});
    return log.losses == 1;
  }));
  EXPECT_EQ(log.connection->in_flight_bytes(), 0u);
}

TEST_F(AcceptedTcp, delivers_what_was_sent_before_a_reset_even_when_writing_fails_first) {
  log.connection->pause();
  client.send("stop the robot");
  client.reset();
  log.connection->send(std::vector{shared("data nobody reads")});
  ASSERT_TRUE(serve_until(loop, [&] {
    log.connection->resume();
    return !log.end.empty();
  }));
  EXPECT_EQ(log.bytes, "stop the robot");
}

TEST_F(AcceptedTcp, tells_of_a_lost_peer_during_a_pause_and_then_reads_it_to_its_end) {
  log.connection->pause();
  client.send(std::string(200000, 'x'));
  client.reset();
  log.connection->send(std::vector{shared("data nobody reads")});
  EXPECT_TRUE(serve_until(loop, [&] { return log.losses == 1; }));
  EXPECT_EQ(log.bytes + log.end, "") << "it is paused";
  log.connection->resume();
  EXPECT_TRUE(serve_until(loop, [&] { return !log.end.empty(); }));
  EXPECT_EQ(log.losses, 1);
}

TEST_F(AcceptedTcp, tells_of_a_lost_peer_during_a_pause_although_nothing_is_sent) {
  client.send("stop the robot");
  log.on_received = [&] { log.connection->pause(); };
  ASSERT_TRUE(serve_until(loop, [&] { return log.bytes == "stop the robot"; }));
  client.send_urgent('!');
  client.send("last words");
  client.reset();
  EXPECT_TRUE(serve_until(loop, [&] { return log.losses == 1; }));
  EXPECT_EQ(log.end, "") << "it is paused";
  log.on_received = [] {};
  log.connection->resume();
  EXPECT_TRUE(serve_until(loop, [&] { return !log.end.empty(); }));
  EXPECT_NE(log.end, "closed") << "it was reset";
  EXPECT_EQ(log.losses, 1);
}

TEST_F(AcceptedTcp, a_peer_that_finished_sending_is_not_lost_during_a_pause) {
  log.connection->pause();
  client.send("that was all");
  client.finish();
  log.connection->send(std::vector{shared("answer")});
  EXPECT_TRUE(serve_until(loop, [&] { return log.drains == 1; }));
  EXPECT_EQ(client.read(6), "answer");
  log.connection->resume();
  EXPECT_TRUE(serve_until(loop, [&] { return log.end == "closed"; }));
  EXPECT_EQ(log.losses, 0);
}

TEST(Tcp, goes_on_accepting_once_there_are_descriptors_again) {
  IoLoop loop;
  Log log;
  auto listener = loop.listen("127.0.0.1", 0, into(log));
  Client first((*listener)->port());
  ASSERT_TRUE(serve_until(loop, [&] { return log.connection != nullptr; }));

  // The sanitizer opens a pipe the first time it looks at an object of a type: those of the log, here.
  log::warn("port {}: the next line is due: {}", (*listener)->port(), std::string("no descriptors"));
  rlimit normal{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &normal), 0);
  const int unused = socket(AF_INET, SOCK_STREAM, 0);  // the lowest descriptor that is free
  close(unused);
  const rlimit none_left{static_cast<rlim_t>(unused) + 1, normal.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none_left), 0);
  Client second((*listener)->port());  // takes the last one
  EXPECT_TRUE(second.connected) << "in the backlog";
  first.send("served");
  EXPECT_TRUE(serve_until(loop, [&] { return log.bytes == "served"; }));
  const std::unique_ptr<Connection> old = std::move(log.connection);
  second.send("patient");
  for (int i = 0; i < 50; ++i) loop.poll();
  EXPECT_EQ(log.connection, nullptr);

  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &normal), 0);
  EXPECT_TRUE(serve_until(loop, [&] { return log.bytes == "servedpatient"; }));
}

TEST_F(AcceptedTcp, keeps_what_a_stalled_peer_does_not_read_in_flight) {
  const std::string big(32u << 20, 'x');
  log.connection->send(std::vector{shared(big)});
  loop.poll();
  EXPECT_GT(log.connection->in_flight_bytes(), 0u);
  EXPECT_EQ(log.drains, 0);
  std::string got;
  std::thread reader([&] { got = client.read(big.size()); });
  EXPECT_TRUE(serve_until(loop, [&] { return log.drains == 1; }));
  reader.join();
  EXPECT_TRUE(got == big);
}

TEST(Tcp, flushes_before_it_closes) {
  IoLoop loop;
  Log log;
  auto listener = loop.listen("127.0.0.1", 0, into(log));
  Client client((*listener)->port());
  client.send("x");
  client.finish();
  ASSERT_TRUE(serve_until(loop, [&] { return !log.end.empty(); }));
  log.connection->send(std::vector{shared("answer")});
  log.connection->close_after_flush();
  log.connection.reset();
  loop.poll();
  EXPECT_EQ(client.read(7), "answer");
}

/// Sends at once what the peer has to read and closes, over input that nobody has read.
void say_and_close(Log& log, const std::string& words) {
  log.connection->pause();
  log.connection->send(std::vector{shared(words)});
  log.connection->close_after_flush();
  log.connection.reset();
}

TEST_F(AcceptedTcp, a_peer_that_sends_all_the_time_and_reads_late_gets_everything) {
  client.send(std::string(100000, 'c'));
  say_and_close(log, "the end of the run");
  for (int i = 0; i < 100; ++i) {
    client.send("command");
    loop.poll();
  }
  EXPECT_EQ(client.read(100), "the end of the run");
  EXPECT_EQ(loop.lingering(), 1u);
  client.finish();
  EXPECT_TRUE(serve_until(loop, [&] { return loop.lingering() == 0; }));
}

TEST(Tcp, does_not_wait_for_a_peer_that_has_ended) {
  IoLoop loop;
  Log log;
  auto listener = loop.listen("127.0.0.1", 0, into(log));
  Client client((*listener)->port());
  client.finish();
  ASSERT_TRUE(serve_until(loop, [&] { return !log.end.empty(); }));
  log.connection->close_after_flush();
  EXPECT_EQ(loop.lingering(), 0u);
}

TEST_F(AcceptedTcp, waits_no_longer_than_it_may_for_a_peer_that_never_ends) {
  say_and_close(log, "bye");
  EXPECT_TRUE(serve_until(loop, [&] { return loop.lingering() == 1; }));
  EXPECT_TRUE(serve_until(loop, [&] { return loop.lingering() == 0; }));
  EXPECT_EQ(client.read(100), "bye");
}

TEST(Tcp, one_that_waits_for_its_peer_gives_way_when_no_descriptor_is_left) {
  IoLoop loop;
  Log log;
  auto listener = loop.listen("127.0.0.1", 0, into(log));
  Client first((*listener)->port());
  ASSERT_TRUE(serve_until(loop, [&] { return log.connection != nullptr; }));
  say_and_close(log, "bye");
  ASSERT_TRUE(serve_until(loop, [&] { return loop.lingering() == 1; }));

  log::warn("port {}: the next line is due: {}", (*listener)->port(), std::string("no descriptors"));
  rlimit normal{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &normal), 0);
  const int unused = socket(AF_INET, SOCK_STREAM, 0);  // the lowest descriptor that is free
  close(unused);
  const rlimit none_left{static_cast<rlim_t>(unused) + 1, normal.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none_left), 0);
  Client second((*listener)->port());  // takes the last one
  loop.poll();
  EXPECT_EQ(loop.lingering(), 0u);
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &normal), 0);
  second.send("served");
  EXPECT_TRUE(serve_until(loop, [&] { return log.bytes == "served"; }));
}

TEST(IoLoop, ends_the_connection_that_has_waited_longest_for_its_peer_when_too_many_do) {
  IoLoop loop;
  IoLoop::Impl& impl = loop.impl();
  std::vector<IoLoop::Impl::Lingering::iterator> places;
  std::vector<std::size_t> ended;
  for (std::size_t i = 0; i < limits::kLingering + 2; ++i) {
    places.push_back(impl.linger([&, i] {
      ended.push_back(i);
      impl.leave(places[i]);
    }));
  }
  EXPECT_EQ(ended, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(loop.lingering(), limits::kLingering);
}

TEST(IoLoop, finishes_when_no_connection_waits_for_its_peer_any_more) {
  IoLoop loop;
  Log log;
  auto listener = loop.listen("127.0.0.1", 0, into(log));
  Client client((*listener)->port());
  ASSERT_TRUE(serve_until(loop, [&] { return log.connection != nullptr; }));
  say_and_close(log, "bye");
  loop.finish();
  std::thread late([&] {
    EXPECT_EQ(client.read(100), "bye");
    client.finish();
  });
  loop.run();
  late.join();
  EXPECT_EQ(loop.lingering(), 0u);
  loop.finish();
  loop.run();  // at once
}

TEST(Tcp, may_be_closed_by_its_owner_inside_an_event) {
  IoLoop loop;
  Log log;
  log.on_received = [&] { log.connection.reset(); };
  auto listener = loop.listen("127.0.0.1", 0, into(log));
  Client client((*listener)->port());
  client.send("x");
  ASSERT_TRUE(serve_until(loop, [&] { return log.bytes == "x"; }));
  EXPECT_EQ(client.read(1), "");
}

TEST(SimulatedNetwork, delivers_everything_in_order_in_pieces) {
  SimulatedNetwork network(7);
  network.piece_bytes = 3;
  Log log;
  auto listener = network.listen("", 6665, into(log));
  SimulatedPeer peer = network.connect(6665);
  int events = 0;
  log.on_received = [&] { ++events; };
  const std::string message(100, 'm');
  peer.send(std::as_bytes(std::span(message)));
  network.run();
  EXPECT_EQ(log.bytes, message);
  EXPECT_GT(events, 33);
  log.connection->send(std::vector{shared(message)});
  network.run();
  EXPECT_EQ(text(peer.take()), message);
  EXPECT_EQ(log.drains, 1);
}

TEST(SimulatedNetwork, holds_back_a_stalled_peer_and_loses_a_vanished_one) {
  SimulatedNetwork network(7);
  network.window_bytes = 10;
  Log log;
  auto listener = network.listen("", 6665, into(log));
  SimulatedPeer peer = network.connect(6665);
  peer.stall();
  network.run();
  log.connection->send(std::vector{shared(std::string(25, 'x'))});
  network.run();
  EXPECT_EQ(log.connection->in_flight_bytes(), 15u);
  EXPECT_EQ(log.drains, 0);
  peer.read_on();
  network.run();
  EXPECT_EQ(log.drains, 1);
  peer.vanish();
  network.run();
  EXPECT_EQ(log.end, "lost");
  EXPECT_EQ(log.losses, 1);
}

TEST(SimulatedNetwork, runs_timers_in_virtual_time) {
  SimulatedNetwork network(7);
  std::string order;
  auto late = network.after(2.0, [&] { order += "b"; });
  auto early = network.after(1.0, [&] { order += "a"; });
  auto never = network.after(9.0, [&] { order += "c"; });
  network.run_for(3.0);
  EXPECT_EQ(order, "ab");
}

TEST(Tcp, connects_by_address_and_by_name_and_carries_bytes_both_ways) {
  for (const char* const host : {"127.0.0.1", "localhost", "ip6-localhost"}) {
    IoLoop loop;
    Log server, client;
    const bool is_name_of_six = std::string_view(host).starts_with("ip6");
    auto listener = *loop.listen(is_name_of_six ? "::" : "127.0.0.1", 0, into(server));
    std::string fault;
    const auto attempt = loop.connect(host, listener->port(), [&](Result<std::unique_ptr<Connection>> made) {
      if (!made) return static_cast<void>(fault = made.error().line());
      client.connection = std::move(*made);
      client.connection->expect_alive();
      client.connection->start(client);
    });
    EXPECT_FALSE(client.connection) << "not before connect() returns";
    ASSERT_TRUE(
        serve_until(loop, [&] { return !fault.empty() || (client.connection && server.connection); }));
    if (is_name_of_six && !fault.empty()) continue;  // a machine that does not know that name
    ASSERT_EQ(fault, "");
    const SharedBytes ping = shared("ping"), pong = shared("pong");
    client.connection->send(std::span(&ping, 1));
    server.connection->send(std::span(&pong, 1));
    ASSERT_TRUE(serve_until(loop, [&] { return server.bytes == "ping" && client.bytes == "pong"; }));
    server.connection.reset();
    ASSERT_TRUE(serve_until(loop, [&] { return !client.end.empty(); }));
  }
}

/// A queue of the system has room for some thousand probes, and a connection of which it drops every probe is lost.
TEST(Tcp, probes_connections_that_were_made_together_at_different_times) {
  constexpr std::size_t kClients = 100;
  IoLoop loop;
  std::vector<std::unique_ptr<Connection>> accepted;
  const auto listener = *loop.listen("127.0.0.1", 0, [&](std::unique_ptr<Connection> connection) {
    accepted.push_back(std::move(connection));
  });
  std::vector<std::unique_ptr<Client>> clients;
  while (clients.size() < kClients) clients.push_back(std::make_unique<Client>(listener->port()));
  ASSERT_TRUE(serve_until(loop, [&] { return accepted.size() == kClients; }));
  std::map<int, std::size_t> probed;  // connections by the seconds of silence before the first probe
  for (int descriptor = 0; descriptor < getdtablesize(); ++descriptor) {
    int is_probed = 0, seconds = 0;
    socklen_t size = sizeof is_probed;
    if (getsockopt(descriptor, SOL_SOCKET, SO_KEEPALIVE, &is_probed, &size) != 0 || is_probed == 0) continue;
    ASSERT_EQ(getsockopt(descriptor, IPPROTO_TCP, TCP_KEEPIDLE, &seconds, &size), 0);
    ++probed[seconds];
  }
  ASSERT_GE(probed.size(), 20u);
  for (const auto& [seconds, connections] : probed) EXPECT_LE(connections, kClients / 10) << seconds << " s";
}

TEST(Tcp, says_why_it_cannot_connect) {
  IoLoop loop;
  const auto fault = [&loop](const std::string& host, std::uint16_t port) {
    std::string told;
    const auto attempt = loop.connect(host, port, [&](Result<std::unique_ptr<Connection>> made) {
      told = made ? "connected" : made.error().line();
    });
    EXPECT_TRUE(serve_until(loop, [&] { return !told.empty(); }));
    return told;
  };
  Log unused;
  std::uint16_t free = 0;
  {
    const auto listener = *loop.listen("127.0.0.1", 0, into(unused));
    free = listener->port();
  }
  EXPECT_EQ(fault("127.0.0.1", free),
            "127.0.0.1:" + std::to_string(free) + ": cannot connect: Connection refused");
  EXPECT_EQ(fault("no such host", 1).substr(0, 30), "no such host:1: cannot connect");
}

TEST(Tcp, an_attempt_that_is_given_up_tells_nothing) {
  IoLoop loop;
  Log server;
  auto listener = *loop.listen("127.0.0.1", 0, into(server));
  auto attempt = loop.connect("127.0.0.1", listener->port(), [](auto&&) { ADD_FAILURE(); });
  attempt.reset();
  bool later = false;
  const auto timer = loop.after(0.05, [&] { later = true; });
  ASSERT_TRUE(serve_until(loop, [&] { return later; }));
}

TEST(SimulatedNetwork, connects_its_own_ports_and_nobody_else) {
  SimulatedNetwork network(3);
  Log server, client;
  std::string fault;
  const auto listener = *network.listen("", 7000, into(server));
  const auto nobody = network.connect(
      "lab", 7001, [&](Result<std::unique_ptr<Connection>> made) { fault = made.error().line(); });
  const auto attempt = network.connect("lab", 7000, [&](Result<std::unique_ptr<Connection>> made) {
    client.connection = std::move(*made);
    client.connection->start(client);
  });
  network.run();
  EXPECT_EQ(fault, "lab:7001: cannot connect: Connection refused");
  const std::string long_text(20000, 'x');
  const SharedBytes there = shared(long_text), back = shared("back");
  client.connection->send(std::span(&there, 1));
  server.connection->send(std::span(&back, 1));
  network.run();
  EXPECT_EQ(server.bytes, long_text);
  EXPECT_EQ(client.bytes, "back");
  EXPECT_EQ(client.drains, 1);
  client.connection.reset();
  network.run();
  EXPECT_EQ(server.end, "closed");
}

TEST(SimulatedNetwork, tells_who_connected_that_the_server_is_gone) {
  SimulatedNetwork network(4);
  Log server, client;
  const auto listener = *network.listen("", 7000, into(server));
  const auto attempt = network.connect("lab", 7000, [&](Result<std::unique_ptr<Connection>> made) {
    client.connection = std::move(*made);
    client.connection->start(client);
  });
  network.run();
  server.connection.reset();
  network.run();
  EXPECT_EQ(client.end, "closed");
}

}  // namespace
}  // namespace playhouse::net
