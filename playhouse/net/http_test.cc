#include "playhouse/net/http.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "playhouse/base/testing/wait.h"
#include "playhouse/net/asio_accept.h"
#include "playhouse/net/asio_http.h"
#include "playhouse/net/fair_share.h"
#include "playhouse/net/testing/web_client.h"

namespace playhouse::net {
namespace {

/// Answers every request with the host and the path it was asked for, or with `answer`.
class Echo final : public HttpService {
 public:
  Result<void> serves(const std::string& host) override {
    return host == "stranger" ? Result<void>(Error{"", "no stranger here"}) : Result<void>();
  }
  HttpReply get(const HttpRequest& request) override {
    HttpReply reply;
    if (answer) {
      reply.text = answer;
      return reply;
    }
    reply.text = std::make_shared<const std::string>(request.host + " " + request.path);
    return reply;
  }
  Result<void> may_upgrade(const HttpRequest&) override { return {}; }
  void upgraded(std::unique_ptr<WebSocket>, const HttpRequest&) override {}
  HttpDeadlines deadlines() const override { return its_deadlines; }
  HttpDeadlines its_deadlines;
  std::shared_ptr<const std::string> answer;
};

class HttpTest : public testing::Test {
 protected:
  explicit HttpTest(HttpDeadlines deadlines = {}) {
    echo_.its_deadlines = deadlines;
    auto listener = loop_.listen_http("127.0.0.1", 0, echo_);
    EXPECT_TRUE(listener.ok());
    listener_ = std::move(*listener);
    io_ = std::thread([this] { loop_.run(); });
  }
  ~HttpTest() override {
    loop_.stop();
    io_.join();
  }

  /// The answer to a head that follows the request line, up to the server's end.
  std::string ask(const std::string& request) { return WebClient(listener_->port()).ask(request + "\r\n"); }
  std::string get(const std::string& fields) {
    return ask("GET / HTTP/1.1\r\nConnection: close\r\n" + fields);
  }
  /// "200", "400" ... of it.
  std::string status(const std::string& fields) { return get(fields).substr(9, 3); }

  Echo echo_;
  IoLoop loop_;
  std::unique_ptr<Listener> listener_;
  std::thread io_;
};

TEST_F(HttpTest, a_request_has_one_host) {
  EXPECT_EQ(status("Host: robo:8080\r\n"), "200");
  EXPECT_EQ(status(""), "400");
  EXPECT_EQ(status("Host: robo\r\nHost: robo\r\n"), "400");
  EXPECT_EQ(status("Host: robo\r\nhost: elsewhere\r\n"), "400");
  for (const char* host : {"", "a b", "robo,elsewhere", "http://robo", "robo/x", "robo:80:80", "robo:x",
                           "robo:123456", "[", "[]", "[::1", "[::1]x", "u@robo", ":80", "ro\tbo"})
    EXPECT_EQ(status("Host: " + std::string(host) + "\r\n"), "400") << host;
  for (const char* host : {"localhost", "robo.lab.example", "127.0.0.1", "[::1]", "[fd00::5]:8080", "robo:"})
    EXPECT_EQ(status("Host: " + std::string(host) + "\r\n"), "200") << host;
  EXPECT_EQ(ask("GET / HTTP/1.0\r\n").substr(9, 3), "200") << "HTTP/1.0 knows no Host";
  EXPECT_EQ(ask("GET / HTTP/1.0\r\nHost: a\r\nHost: b\r\n").substr(9, 3), "400");
}

TEST_F(HttpTest, a_host_that_the_service_does_not_serve_is_misdirected) {
  EXPECT_EQ(status("Host: stranger\r\n"), "421");
  EXPECT_EQ(ask("GET http://stranger/ HTTP/1.1\r\nHost: robo\r\n").substr(9, 3), "421");
  WebClient viewer(listener_->port());
  viewer.ask_to_upgrade("", "stranger");
  EXPECT_FALSE(viewer.upgraded());
}

TEST_F(HttpTest, a_length_that_can_be_read_in_two_ways_is_refused) {
  const std::string host = "Host: robo\r\n";
  EXPECT_EQ(status(host + "Content-Length: 5\r\nContent-Length: 6\r\n"), "400");
  EXPECT_EQ(status(host + "Content-Length: 5, 6\r\n"), "400");
  EXPECT_EQ(status(host + "Content-Length: +0\r\n"), "400");
  EXPECT_EQ(status(host + "Content-Length: -1\r\n"), "400");
  EXPECT_EQ(status(host + "Content-Length: 99999999999999999999999\r\n"), "400");
  EXPECT_EQ(status(host + "Content-Length: 5\r\nTransfer-Encoding: chunked\r\n"), "400");
  EXPECT_EQ(status(host + "Transfer-Encoding: chunked\r\nContent-Length: 5\r\n"), "400");
  EXPECT_EQ(status(host + "Transfer-Encoding: chunked\r\nTransfer-Encoding: chunked\r\n"), "400");
  EXPECT_EQ(status(host + "Transfer-Encoding: gzip\r\n"), "400");
  EXPECT_EQ(status(host + "Transfer-Encoding: chunked, gzip\r\n"), "400");
  EXPECT_EQ(status(host + "Transfer-Encoding: xchunked\r\n"), "400");
  EXPECT_EQ(ask("GET / HTTP/1.0\r\n" + host + "Transfer-Encoding: chunked\r\n").substr(9, 3), "400");
  EXPECT_EQ(status(host + "Content-Length : 5\r\n"), "400") << "a blank before the colon";
  EXPECT_EQ(status(host + " Content-Length: 5\r\n"), "400") << "a folded line";
  EXPECT_EQ(status("X: y\nHost: robo\r\n"), "400") << "a bare line feed";
  EXPECT_EQ(status(host + "Transfer-Encoding: chunked\r\n"), "413");
  EXPECT_EQ(status(host + "Content-Length: 5\r\n"), "413");
  EXPECT_EQ(status(host + "Content-Length: 0\r\n"), "200");
}

TEST_F(HttpTest, what_follows_a_refused_request_is_no_request) {
  const std::string answer =
      ask("GET / HTTP/1.1\r\nHost: robo\r\nContent-Length: 4\r\nTransfer-Encoding: "
          "chunked\r\n\r\n0\r\n\r\nGET /smuggled "
          "HTTP/1.1\r\nHost: robo\r\n");
  EXPECT_EQ(answer.find("smuggled"), std::string::npos) << answer;
  EXPECT_EQ(answer.find("HTTP/1.1", 1), std::string::npos) << answer;
}

TEST_F(HttpTest, the_target_is_a_path_or_a_whole_address_whose_host_counts) {
  EXPECT_TRUE(get("Host: robo\r\n").ends_with("robo /"));
  const auto target = [this](const std::string& text) {
    return ask("GET " + text + " HTTP/1.1\r\nHost: robo\r\nConnection: close\r\n");
  };
  EXPECT_TRUE(target("/a?b=c").ends_with("robo /a"));
  EXPECT_TRUE(target("http://other:81/a?b").ends_with("other:81 /a"));
  EXPECT_TRUE(target("HTTP://other").ends_with("other /"));
  EXPECT_TRUE(target("http://other?/b").ends_with("other /"));
  for (const char* bad :
       {"http://", "http:///a", "http://u@other/", "https://other/", "*", "other:80", "a/b"})
    EXPECT_EQ(target(bad).substr(9, 3), "400") << bad;
}

TEST_F(HttpTest, methods_and_versions_that_are_not_served_are_refused_by_name) {
  for (const char* method : {"POST", "PUT", "OPTIONS", "CONNECT", "TRACE"})
    EXPECT_EQ(ask(method + std::string(" / HTTP/1.1\r\nHost: robo\r\n")).substr(9, 3), "405") << method;
  EXPECT_EQ(ask("BREW / HTTP/1.1\r\nHost: robo\r\n").substr(9, 3), "501");
  EXPECT_EQ(ask("GET / HTTP/2.0\r\nHost: robo\r\n").substr(9, 3), "505");
  EXPECT_EQ(ask("PRI * HTTP/2.0\r\n").substr(9, 3), "505");
}

TEST_F(HttpTest, an_answer_arrives_although_nobody_reads_the_body) {
  WebClient client(listener_->port());
  const std::string body(1 << 20, 'x');
  EXPECT_TRUE(client.ask("POST / HTTP/1.1\r\nHost: robo\r\nContent-Length: 1048576\r\n\r\n" + body)
                  .starts_with("HTTP/1.1 413"));
}

TEST_F(HttpTest, requests_in_one_piece_are_answered_in_turn) {
  WebClient client(listener_->port());
  const std::string answers = client.ask(
      "GET /a HTTP/1.1\r\nHost: robo\r\n\r\nGET /b HTTP/1.1\r\nHost: robo\r\nConnection: close\r\n\r\n");
  const std::size_t first = answers.find("robo /a"), second = answers.find("robo /b");
  EXPECT_LT(first, second);
  EXPECT_TRUE(answers.ends_with("robo /b"));
}

class ShortDeadlinesTest : public HttpTest {
 protected:
  static constexpr std::chrono::milliseconds kShort{50}, kLong = std::chrono::hours(1);
  explicit ShortDeadlinesTest(HttpDeadlines deadlines) : HttpTest(deadlines) {}
  static bool never(const std::string&) { return false; }
};

class ShortIdleTest : public ShortDeadlinesTest {
 protected:
  ShortIdleTest() : ShortDeadlinesTest({.idle = kShort, .head = kLong, .answer = kLong}) {}
};

TEST_F(ShortIdleTest, a_connection_without_a_request_is_closed_also_after_one) {
  WebClient silent(listener_->port()), kept(listener_->port());
  kept.send("GET /a HTTP/1.1\r\nHost: robo\r\n\r\n");
  silent.read_until(never);
  EXPECT_TRUE(silent.ended());
  kept.read_until(never);
  EXPECT_TRUE(kept.ended());
  EXPECT_TRUE(kept.in.ends_with("robo /a"));
}

class ShortHeadTest : public ShortDeadlinesTest {
 protected:
  ShortHeadTest() : ShortDeadlinesTest({.idle = kLong, .head = kShort, .answer = kLong}) {}
};

TEST_F(ShortHeadTest, a_head_that_comes_byte_by_byte_is_not_waited_for) {
  WebClient slow(listener_->port());
  slow.send("GET / HTTP/1.1\r\nHost: robo\r\nX: ");
  slow.read_until(never, [&] { slow.send("x"); });
  EXPECT_TRUE(slow.ended());
}

class ShortAnswerTest : public ShortDeadlinesTest {
 protected:
  ShortAnswerTest() : ShortDeadlinesTest({.idle = kLong, .head = kLong, .answer = kShort}) {}
};

TEST_F(ShortAnswerTest, an_answer_that_nobody_reads_is_not_kept) {
  echo_.answer = std::make_shared<const std::string>(64u << 20, 'x');
  WebClient reader(listener_->port());
  reader.send("GET / HTTP/1.1\r\nHost: robo\r\n\r\n");
  EXPECT_TRUE(wait_until([this] { return echo_.answer.use_count() > 1; }));
  EXPECT_TRUE(wait_until([this] { return echo_.answer.use_count() == 1; })) << "the connection lets go of it";
  EXPECT_TRUE(wait_until([&] { return reader.closed(); }));
  EXPECT_LT(reader.in.size(), echo_.answer->size());
}

/// A WebSocket whose owner closes it with a reason as soon as it can be read from.
class ClosedByOwnerTest : public testing::Test {
 protected:
  class Owner final : public HttpService, public WebSocketEvents {
   public:
    Result<void> serves(const std::string&) override { return {}; }
    HttpReply get(const HttpRequest&) override { return {}; }
    Result<void> may_upgrade(const HttpRequest&) override { return {}; }
    void upgraded(std::unique_ptr<WebSocket> socket, const HttpRequest&) override {
      socket->start(*this);
      if (first) socket->send_binary(first);
      socket->close("enough");
    }
    void received(std::string_view) override { ADD_FAILURE() << "an event after the end"; }
    void drained() override { ADD_FAILURE() << "an event after the end"; }
    void closed(const std::string&) override { ADD_FAILURE() << "an event after the end"; }
    SharedBytes first;  // a message that is being sent when the socket is closed
  };

  ClosedByOwnerTest() {
    auto listener = listen_tcp(loop_.impl(), "127.0.0.1", 0, [this](AcceptedSocket accepted) {
      serve_http(std::move(accepted), owner_, {}, places_);
    });
    EXPECT_TRUE(listener.ok());
    listener_ = std::move(*listener);
    io_ = std::thread([this] { loop_.run(); });
  }
  ~ClosedByOwnerTest() override {
    loop_.stop();
    io_.join();
  }

  /// The server has closed its socket, although this end is still open.
  bool let_go() {
    return wait_until([this] { return places_.use_count() == 1; });
  }

  Owner owner_;
  std::shared_ptr<HttpPlaces> places_ = std::make_shared<HttpPlaces>();  // each connection holds it as well
  IoLoop loop_;
  std::unique_ptr<Listener> listener_;
  std::thread io_;
};

const std::string kCloseFrame = "\x88\x08\x03\xF0" + std::string("enough");  // 1008: policy violation

TEST_F(ClosedByOwnerTest, a_peer_that_closes_as_well_ends_it) {
  WebClient peer(listener_->port());
  ASSERT_TRUE(peer.upgrade());
  EXPECT_TRUE(peer.read_until([](const std::string& in) { return in.size() >= kCloseFrame.size(); }));
  peer.send(std::string("\x88\x82\0\0\0\0\x03\xF0", 8));
  EXPECT_TRUE(let_go());
  EXPECT_TRUE(peer.closed());
  EXPECT_EQ(peer.in, kCloseFrame) << "nothing follows a close frame";
}

TEST_F(ClosedByOwnerTest, a_peer_that_sends_rubbish_does_not_keep_it_open) {
  WebClient peer(listener_->port());
  ASSERT_TRUE(peer.upgrade());
  EXPECT_TRUE(peer.read_until([](const std::string& in) { return in.size() >= kCloseFrame.size(); }));
  peer.send(std::string(64, '\xFF'));
  EXPECT_TRUE(let_go());
}

TEST_F(ClosedByOwnerTest, a_peer_that_stays_does_not_keep_it_open) {
  WebClient peer(listener_->port());
  ASSERT_TRUE(peer.upgrade());
  EXPECT_TRUE(let_go());
  EXPECT_TRUE(peer.closed());
  EXPECT_EQ(peer.in, kCloseFrame);
}

TEST_F(ClosedByOwnerTest, a_peer_that_does_not_take_what_is_being_sent_does_not_keep_it_open) {
  owner_.first = std::make_shared<std::vector<std::byte>>(64u << 20);
  WebClient peer(listener_->port());
  ASSERT_TRUE(peer.upgrade());
  EXPECT_TRUE(let_go());
  EXPECT_TRUE(wait_until([this] { return owner_.first.use_count() == 1; })) << "nor the message";
}

/// Clients that send half a head, each from the first to the last of `hosts` in turn.
std::vector<std::unique_ptr<WebClient>> slow_clients(std::uint16_t port, std::size_t count,
                                                     const std::vector<std::string>& hosts) {
  std::vector<std::unique_ptr<WebClient>> clients;
  for (std::size_t k = 0; k < count; ++k) {
    clients.push_back(std::make_unique<WebClient>(port, hosts[k % hosts.size()]));
    clients.back()->send("GET / HTTP/1.1\r\nHost: robo\r\n");
  }
  return clients;
}

std::size_t open_ones(const std::vector<std::unique_ptr<WebClient>>& clients) {
  return static_cast<std::size_t>(
      std::ranges::count_if(clients, [](const auto& client) { return !client->closed(); }));
}

TEST_F(HttpTest, connections_that_wait_give_way_to_one_that_comes) {
  const auto slow = slow_clients(listener_->port(), 300, {"127.0.0.1"});
  EXPECT_EQ(status("Host: robo\r\n"), "200");
  EXPECT_EQ(open_ones(slow), limits::kHttpConnectionsPerAddress - 1) << "one gave way to the last request";
  EXPECT_TRUE(slow.front()->closed());
  EXPECT_FALSE(slow.back()->closed()) << "the ones that waited longest went";
  EXPECT_TRUE(slow.back()->ask("Connection: close\r\n\r\n").ends_with("robo /"));
}

TEST_F(HttpTest, a_crowd_of_some_addresses_takes_no_place_of_another) {
  const auto first = slow_clients(listener_->port(), 3, {"127.0.0.1"});
  const auto crowd = slow_clients(listener_->port(), 400, {"127.0.0.2", "127.0.0.3", "127.0.0.4"});
  EXPECT_EQ(status("Host: robo\r\n"), "200");
  EXPECT_EQ(open_ones(first), 3u);
  EXPECT_EQ(open_ones(crowd), limits::kHttpConnections - 3 - 1);
  EXPECT_TRUE(first.front()->ask("Connection: close\r\n\r\n").ends_with("robo /"));
}

TEST(FairShare, a_network_is_an_address_or_half_of_one) {
  EXPECT_EQ(network_of("10.0.0.7:4242"), "10.0.0.7");
  EXPECT_EQ(network_of("[fd00::7:1]:4242"), network_of("[fd00::8]:1"));
  EXPECT_NE(network_of("[fd00:0:0:1::7]:4242"), network_of("[fd00::7]:4242"));
  EXPECT_EQ(network_of("[::ffff:10.0.0.7]:4242"), "10.0.0.7");
  EXPECT_NE(network_of("[fe80::1%lo]:1"), "");
  EXPECT_EQ(holder_of("blue-chair-7", "10.0.0.7:4242"), "blue-chair-7");
  EXPECT_EQ(holder_of("*", "10.0.0.7:4242"), holder_of("*", "10.0.0.7:4243"));
  EXPECT_NE(holder_of("*", "127.0.0.1:4242"), holder_of("*", "127.0.0.1:4243")) << "whoever is behind them";
  for (const char* peer : {"127.0.0.1:1", "127.8.8.8:1", "[::1]:1", "[::ffff:127.0.0.1]:1"})
    EXPECT_TRUE(is_local(peer)) << peer;
  for (const char* peer : {"10.0.0.7:1", "[fd00::1]:1", "[::ffff:10.0.0.7]:1"})
    EXPECT_FALSE(is_local(peer)) << peer;
}

TEST(FairShare, the_quietest_of_the_largest_network_gives_way) {
  const Holder holders[] = {{"a", 1}, {"b", 5}, {"b", 3}, {"c", 4}, {"c", 9}};
  EXPECT_EQ(gives_way(holders), 2u);
  EXPECT_EQ(gives_way(std::span(holders).first(1)), 0u);
  EXPECT_EQ(places_of(holders, "c"), 2u);
  EXPECT_EQ(places_of(holders, "d"), 0u);
}

}  // namespace
}  // namespace playhouse::net
