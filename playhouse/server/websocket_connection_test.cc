// Player's byte stream over a WebSocket: the same bytes as over TCP, however they are cut into messages.

#include "playhouse/server/websocket_connection.h"

#include <gtest/gtest.h>

#include "playhouse/net/http.h"
#include "playhouse/net/simulated_page.h"
#include "playhouse/server/fake_driver.h"
#include "playhouse/server/server.h"
#include "playhouse/server/test_client.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::server {
namespace {

constexpr std::uint16_t kPort = 6665, kWebPort = 8080;
constexpr std::uint16_t kLaser = wire::laser::kCode;

class WebSocketTest : public ::testing::Test, private net::HttpService {
 protected:
  WebSocketTest() {
    EXPECT_TRUE(server_.listen(kPort).ok());
    laser_id_ = *server_.add_device({kPort, kLaser, 0}, laser_);
    listener_ = *network_.listen_http("127.0.0.1", kWebPort, *this);
  }

  net::SimulatedPage open() {
    net::SimulatedPage page = network_.open_page(kWebPort, {.path = "/player", .peer = "127.0.0.1:4242"});
    network_.run();
    return page;
  }
  static void send(net::SimulatedPage& page, const Bytes& bytes) {
    page.send(net::SimulatedPage::SocketMessage{false, bytes});
  }
  /// The bytes of all messages since the last call, which must be binary.
  Bytes read(net::SimulatedPage& page) {
    network_.run();
    Bytes bytes;
    for (const auto& message : page.take()) {
      EXPECT_FALSE(message.is_text);
      bytes.insert(bytes.end(), message.bytes.begin(), message.bytes.end());
    }
    return bytes;
  }
  void publish(std::size_t bytes) {
    std::vector<device::Publication> batch;
    batch.push_back({laser_id_, wire::laser::kDataScan, 1.5, Bytes(bytes)});
    server_.publish(std::move(batch));
  }

  net::SimulatedNetwork network_{11};
  FakeDriver laser_{"stage"};
  Server server_{network_};
  device::DeviceId laser_id_;
  std::unique_ptr<net::Listener> listener_;

 private:
  Result<void> serves(const std::string&) override { return {}; }
  net::HttpReply get(const net::HttpRequest&) override { return {}; }
  Result<void> may_upgrade(const net::HttpRequest&) override { return {}; }
  void upgraded(std::unique_ptr<net::WebSocket> socket, const net::HttpRequest&) override {
    server_.accept(kPort, websocket_connection(std::move(socket)));
  }
};

TEST_F(WebSocketTest, a_client_gets_the_bytes_that_one_over_tcp_gets) {
  TestClient other(network_, kPort);
  net::SimulatedPage page = open();
  Bytes bytes = read(page);
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()), other.banner);
  send(page, open_request(kLaser, 0));
  bytes = read(page);
  const auto opened = cut_messages(bytes);
  ASSERT_EQ(opened.size(), 1u);
  EXPECT_EQ(access_of(opened[0]), 1);
  const auto same = other.ask(open_request(kLaser, 0));
  EXPECT_EQ(opened[0].body, same[0].body);
  publish(52);
  bytes = read(page);
  const auto data = cut_messages(bytes);
  ASSERT_EQ(data.size(), 1u);
  EXPECT_EQ(data[0].body, other.read().at(0).body);
  EXPECT_EQ(server_.clients().size(), 2u);
  EXPECT_EQ(server_.clients()[1].peer, "127.0.0.1:4242");
  EXPECT_EQ(server_.clients()[1].open, (std::vector<device::Address>{{kPort, kLaser, 0}}));
}

TEST_F(WebSocketTest, messages_may_cut_the_stream_anywhere) {
  net::SimulatedPage page = open();
  read(page);
  Bytes stream = open_request(kLaser, 0);
  const Bytes second = mode_request(1);
  stream.insert(stream.end(), second.begin(), second.end());
  for (const std::byte byte : stream) send(page, {byte});
  Bytes bytes = read(page);
  EXPECT_EQ(outline(cut_messages(bytes)), "ACK 3, ACK 5");
}

TEST_F(WebSocketTest, a_page_that_reads_slowly_is_sent_no_more_than_it_takes) {
  net::SimulatedPage page = open();
  send(page, open_request(kLaser, 0));
  read(page);
  page.stall();
  for (int count = 0; count < 2000; ++count) {
    publish(10000);
    network_.run();
  }
  EXPECT_GT(server_.status().data_dropped, 0u);
  EXPECT_LT(server_.status().output_bytes, std::size_t{limits::kSessionQueueMessages} * 11000);
  page.read_on();
  publish(52);
  Bytes bytes = read(page);
  EXPECT_FALSE(cut_messages(bytes).empty());
}

TEST_F(WebSocketTest, a_text_message_ends_it_and_what_it_had_open_is_closed) {
  net::SimulatedPage page = open();
  send(page, open_request(kLaser, 0));
  read(page);
  EXPECT_TRUE(server_.has_readers(laser_id_));
  page.send("hello");
  network_.run_for(10);
  EXPECT_FALSE(server_.has_readers(laser_id_));
  EXPECT_TRUE(server_.clients().empty());
  EXPECT_TRUE(page.closed());
}

TEST_F(WebSocketTest, a_page_that_closes_leaves_nothing_open) {
  net::SimulatedPage page = open();
  send(page, open_request(kLaser, 0));
  page.finish();
  network_.run_for(10);
  EXPECT_FALSE(server_.has_readers(laser_id_));
  EXPECT_TRUE(server_.clients().empty());
}

}  // namespace
}  // namespace playhouse::server
