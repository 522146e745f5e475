#include "playhouse/net/simulated.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

#include "playhouse/net/http.h"
#include "playhouse/net/testing_bytes.h"

namespace playhouse::net {
namespace {

/// A server that keeps what its one client sends.
struct Sink final : ConnectionEvents {
  explicit Sink(SimulatedNetwork& network)
      : listener(*network.listen("127.0.0.1", 1, [this](std::unique_ptr<Connection> accepted) {
          connection = std::move(accepted);
          connection->start(*this);
        })) {}
  void received(std::span<const std::byte> part) override { bytes += text(part); }
  void drained() override {}
  void lost() override {}
  void closed(const std::string& why) override { end = why; }
  std::unique_ptr<Connection> connection;
  std::string bytes, end;
  std::unique_ptr<Listener> listener;
};

TEST(SimulatedConnection, is_delayed_in_both_directions_and_keeps_the_order) {
  SimulatedNetwork network(1);
  network.piece_bytes = 3;
  network.connections = {.delay = 0.1, .jitter = 0.2};
  Sink sink(network);
  SimulatedPeer peer = network.connect(1);
  network.run();
  std::string sent;
  for (char letter = 'a'; letter <= 'z'; ++letter) {
    sent += letter;
    peer.send(*shared(std::string(1, letter)));
    const SharedBytes echo[] = {shared(std::string(1, letter))};
    sink.connection->send(echo);
    network.run();
  }
  peer.finish();
  network.run_for(0.09);
  EXPECT_EQ(sink.bytes, "");
  EXPECT_EQ(text(peer.take()), "");
  EXPECT_EQ(sink.end, "");
  network.run_for(0.22);
  EXPECT_EQ(sink.bytes, sent);
  EXPECT_EQ(text(peer.take()), sent);
  EXPECT_EQ(sink.end, "closed");
}

TEST(SimulatedConnection, delivers_after_a_cut_what_was_sent_before_and_meanwhile) {
  SimulatedNetwork network(1);
  Sink sink(network);
  SimulatedPeer peer = network.connect(1);
  network.run();
  peer.send(*shared("before "));
  network.cut(5);
  network.run_for(2);
  peer.send(*shared("meanwhile"));
  const SharedBytes answer[] = {shared("answer")};
  sink.connection->send(answer);
  SimulatedPeer second = network.connect(1);
  network.run_for(2.9);
  EXPECT_TRUE(network.is_cut());
  EXPECT_EQ(sink.bytes, "");
  EXPECT_EQ(sink.connection->in_flight_bytes(), 0u);  // the system has taken them
  EXPECT_EQ(text(peer.take()), "");
  Connection* const first = sink.connection.get();
  network.run_for(0.1);
  EXPECT_FALSE(network.is_cut());
  EXPECT_EQ(sink.bytes, "before meanwhile");
  EXPECT_EQ(text(peer.take()), "answer");
  EXPECT_NE(sink.connection.get(), first);
}

/// Sends back what pages say, and refuses those at "/no".
struct Echoes final : HttpService, WebSocketEvents {
  Result<void> serves(const std::string&) override { return {}; }
  HttpReply get(const HttpRequest&) override { return {}; }
  Result<void> may_upgrade(const HttpRequest& request) override {
    if (request.path == "/no") return Error{"", "pages connect to /yes"};
    return {};
  }
  void upgraded(std::unique_ptr<WebSocket> upgraded, const HttpRequest&) override {
    socket = std::move(upgraded);
    socket->start(*this);
  }
  void received(std::string_view words) override {
    socket->send_text(std::make_shared<const std::string>(words));
    socket->send_binary(shared(words));
  }
  void drained() override { ++drains; }
  void closed(const std::string& why) override { end = why; }
  std::unique_ptr<WebSocket> socket;
  std::string end;
  int drains = 0;
};

TEST(SimulatedPage, sends_and_gets_whole_messages_late) {
  SimulatedNetwork network(1);
  network.connections.delay = 0.1;
  Echoes echoes;
  const auto listener = *network.listen_http("127.0.0.1", 8080, echoes);
  SimulatedPage page = network.open_page(8080, {.path = "/yes", .peer = "10.0.0.2:1"});
  network.run();
  EXPECT_EQ(echoes.socket->peer(), "10.0.0.2:1");
  page.send("hello");
  network.run_for(0.19);
  EXPECT_TRUE(page.take().empty());
  network.run_for(0.02);
  const auto messages = page.take();
  ASSERT_EQ(messages.size(), 2u);
  EXPECT_TRUE(messages[0].is_text);
  EXPECT_FALSE(messages[1].is_text);
  EXPECT_EQ(text(messages[0].bytes), "hello");
  EXPECT_EQ(echoes.drains, 1);
  page.send("again");
  page.finish();
  network.run_for(0.1);
  EXPECT_EQ(echoes.end, "closed");
}

TEST(SimulatedPage, that_stalls_leaves_messages_in_flight_and_hears_why_it_is_closed) {
  SimulatedNetwork network(1);
  network.window_bytes = 10;
  Echoes echoes;
  const auto listener = *network.listen_http("127.0.0.1", 8080, echoes);
  SimulatedPage page = network.open_page(8080, {.path = "/yes"});
  network.run();
  page.stall();
  for (int k = 0; k < 5; ++k) page.send("0123456789");
  network.run();
  EXPECT_EQ(echoes.socket->messages_in_flight(), 9u);
  echoes.socket->close("enough");
  page.read_on();
  network.run();
  EXPECT_EQ(page.take().size(), 10u);
  EXPECT_EQ(page.closed(), "enough");
}

TEST(SimulatedPage, that_is_refused_or_vanishes) {
  SimulatedNetwork network(1);
  Echoes echoes;
  auto listener = *network.listen_http("127.0.0.1", 8080, echoes);
  const SimulatedPage refused = network.open_page(8080, {.path = "/no"});
  SimulatedPage page = network.open_page(8080, {.path = "/yes"});
  network.run();
  EXPECT_EQ(refused.closed(), "pages connect to /yes");
  page.send("hello");
  page.vanish();
  network.run();
  EXPECT_EQ(echoes.end, "lost");
  EXPECT_TRUE(page.take().empty());
}

}  // namespace
}  // namespace playhouse::net
