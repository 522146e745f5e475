// Data by multicast, on the simulated network. Real sockets: tests/e2e/test_transports.py.

#include "playhouse/server/multicast_group.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/server/fake_driver.h"
#include "playhouse/server/server.h"
#include "playhouse/server/test_client.h"
#include "playhouse/wire/generated/common.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/sonar.h"

namespace playhouse::server {
namespace {

constexpr std::uint16_t kScanner = wire::laser::kCode, kSonars = wire::sonar::kCode;
constexpr std::uint16_t kServed = 6665;
const std::string kGroupHost = "239.255.0.1";
constexpr std::uint16_t kGroupPort = 6680;

Bytes group_question() {
  return player_request(wire::kReqGetStrprop,
                        wire::encode(wire::StrpropReq{wire::c_string("multicast"), ""}));
}
Bytes group_request(std::int32_t value) {
  return player_request(wire::kReqSetIntprop,
                        wire::encode(wire::IntpropReq{wire::c_string("multicast"), value}));
}

class MulticastSessions : public ::testing::Test {
 protected:
  MulticastSessions() {
    EXPECT_EQ(*server.listen(kServed), kServed);
    scanner_id = *server.add_device({kServed, kScanner, 0}, scanner);
    sonar_id = *server.add_device({kServed, kSonars, 0}, sonar);
  }
  void publish(device::DeviceId device, double time, std::size_t bytes = 52,
               std::vector<std::uint32_t> clients = {}) {
    std::vector<device::Publication> batch;
    batch.push_back({device, 1, time, Bytes(bytes), std::move(clients)});
    server.publish(std::move(batch));
  }
  /// The group's datagrams since the last call.
  std::vector<Received> heard() {
    network.run_for(1);
    std::vector<Received> messages;
    for (Bytes& each : std::exchange(datagrams_, {}))
      for (Received& message : cut_messages(each)) messages.push_back(std::move(message));
    return messages;
  }
  void open(TestClient& client, std::uint16_t interf) {
    EXPECT_EQ(outline(client.ask(open_request(interf, 0))), "ACK 3");
  }

  net::SimulatedNetwork network{5};
  FakeDriver scanner{"stage"}, sonar{"stage"};
  Server server{network, {.group = *net::parse_endpoint(kGroupHost, kGroupPort)}};
  device::DeviceId scanner_id, sonar_id;

 private:
  std::vector<Bytes> datagrams_;
  std::unique_ptr<net::DatagramSocket> listener_ = *network.open_datagrams(
      kGroupHost, kGroupPort, [this](const net::Endpoint&, std::span<const std::byte> bytes) {
        datagrams_.emplace_back(bytes.begin(), bytes.end());
      });
};

TEST_F(MulticastSessions, send_data_once_for_all_who_ask_and_to_the_others_each) {
  TestClient one(network, kServed), two(network, kServed), other(network, kServed);
  for (TestClient* const each : {&one, &two, &other}) open(*each, kScanner);
  EXPECT_EQ(outline(one.ask(group_request(1))), "ACK 253");
  EXPECT_EQ(outline(two.ask(group_request(1))), "ACK 253");
  for (int i = 0; i < 3; ++i) publish(scanner_id, 10 + i);
  const std::vector<Received> data = heard();
  EXPECT_EQ(outline(data), "DATA 1 of 6, DATA 1 of 6, DATA 1 of 6");
  for (std::uint32_t i = 0; i < data.size(); ++i) EXPECT_EQ(data[i].header.seq, i + 1);
  EXPECT_EQ(data.at(0).header.robot, kServed);
  EXPECT_EQ(outline(one.read()), "");
  EXPECT_EQ(outline(two.read()), "");
  EXPECT_EQ(outline(other.read()), "DATA 1 of 6, DATA 1 of 6, DATA 1 of 6");
  EXPECT_EQ(server.status().group.sent, 3u);
  EXPECT_EQ(server.status().messages_encoded, 3u);
}

TEST_F(MulticastSessions, tell_where_the_group_is) {
  TestClient client(network, kServed);
  const std::vector<Received> answer = client.ask(group_question());
  ASSERT_EQ(outline(answer), "ACK 250");
  const std::string place(wire::text(wire::decode<wire::StrpropReq>(answer[0].body)->value));
  EXPECT_TRUE(place.starts_with("239.255.0.1:6680 from 127.0.0.1:4")) << place;
}

TEST_F(MulticastSessions, number_the_messages_of_each_device) {
  TestClient client(network, kServed);
  client.ask(group_request(1));
  open(client, kScanner);
  open(client, kSonars);
  for (const device::DeviceId device : {scanner_id, sonar_id, sonar_id, scanner_id}) publish(device, 1);
  std::string numbers;
  for (const Received& each : heard())
    numbers += std::to_string(each.header.interf) + ":" + std::to_string(each.header.seq) + " ";
  EXPECT_EQ(numbers, "6:1 5:1 5:2 6:2 ");
}

TEST_F(MulticastSessions, go_on_counting_at_an_address_whose_device_is_another) {
  TestClient client(network, kServed);
  client.ask(group_request(1));
  open(client, kScanner);
  publish(scanner_id, 1);
  publish(scanner_id, 2);
  EXPECT_EQ(heard().size(), 2u);
  server.retire_device(scanner_id);
  client.read();
  scanner_id = *server.add_device({kServed, kScanner, 0}, scanner);
  open(client, kScanner);
  publish(scanner_id, 3);
  const std::vector<Received> data = heard();
  ASSERT_EQ(data.size(), 1u);
  EXPECT_EQ(data[0].header.seq, 3u);
}

TEST_F(MulticastSessions, keep_to_the_connection_what_is_for_one_client_or_longer_than_a_datagram) {
  TestClient client(network, kServed);
  client.ask(group_request(1));
  open(client, kScanner);
  const std::uint32_t serial = 1;
  publish(scanner_id, 1, 52, {serial});
  EXPECT_EQ(outline(client.read()), "DATA 1 of 6");
  publish(scanner_id, 2, limits::kDatagramMostBytes);
  EXPECT_EQ(outline(client.read()), "DATA 1 of 6");
  EXPECT_TRUE(heard().empty());
  publish(scanner_id, 3, limits::kDatagramMostBytes - limits::kHeaderBytes);
  EXPECT_EQ(heard().size(), 1u);
}

TEST_F(MulticastSessions, send_nothing_to_the_group_that_nobody_reads_there) {
  TestClient client(network, kServed);
  open(client, kScanner);
  publish(scanner_id, 1);
  EXPECT_TRUE(heard().empty());
  EXPECT_EQ(outline(client.read()), "DATA 1 of 6");
  client.ask(group_request(1));
  publish(scanner_id, 2);
  EXPECT_EQ(heard().size(), 1u);
  client.ask(group_request(0));
  publish(scanner_id, 3);
  EXPECT_TRUE(heard().empty());
  EXPECT_EQ(outline(client.read()), "DATA 1 of 6");
}

TEST(Multicast, tells_the_senders_port_alone_where_the_system_chooses_its_address) {
  net::SimulatedNetwork network{5};
  for (const char* const bind : {"0.0.0.0", "::"}) {
    const auto group = *MulticastGroup::open(network, bind, *net::parse_endpoint(kGroupHost, kGroupPort));
    EXPECT_TRUE(group->place().starts_with("239.255.0.1:6680 from 4")) << group->place();
    EXPECT_EQ(group->place().rfind(':'), std::string("239.255.0.1").size()) << group->place();
  }
}

TEST(Multicast, excludes_tokens_as_everybody_reads_it) {
  net::SimulatedNetwork network{5};
  Server server{network, {.group = *net::parse_endpoint(kGroupHost, kGroupPort)}};
  server.admit_by([](auto&&...) { return std::nullopt; });
  const auto listening = server.listen(kServed);
  ASSERT_FALSE(listening);
  EXPECT_TRUE(listening.error().line().starts_with("239.255.0.1:6680: invalid group"))
      << listening.error().line();
}

/// Of a system that takes nothing while it is told so.
class BrokenSocket final : public net::DatagramSocket {
 public:
  explicit BrokenSocket(const bool& works) : works_(works) {}
  bool send(const net::Endpoint&, std::span<const std::byte>) override { return works_; }
  void on_refused(std::function<void(const net::Endpoint&)>) override {}
  std::uint16_t port() const override { return 41234; }

 private:
  const bool& works_;
};

class GroupReader final : public Subscriber {
 public:
  std::uint32_t serial() const override { return 1; }
  void deliver(const Frame&) override { ++delivered; }
  void lose(std::uint64_t) override {}
  bool reads_group() const override { return true; }

  int delivered = 0;
};

TEST(Multicast, what_the_system_does_not_take_goes_to_each_reader_without_a_number) {
  bool works = false;
  MulticastGroup group(std::make_unique<BrokenSocket>(works), "41234",
                       *net::parse_endpoint(kGroupHost, kGroupPort));
  struct Numbers final : ReaderGroup {
    explicit Numbers(ReaderGroup& told) : group(told) {}
    bool carries(const Frame& frame) const override { return group.carries(frame); }
    bool send(const Frame& frame, std::uint32_t number) override {
      numbers.push_back(number);
      return group.send(frame, number);
    }
    ReaderGroup& group;
    std::vector<std::uint32_t> numbers;
  } watched(group);
  Fanout fanout(std::make_shared<std::size_t>(0));
  fanout.share_by(watched);
  GroupReader one, two;
  const device::DeviceId device{};
  fanout.join(device, one);
  fanout.join(device, two);
  const auto publish = [&](double time) {
    return fanout.publish({device, 1, time, Bytes(52), {}}, {kServed, kScanner, 0}, time);
  };
  EXPECT_EQ(publish(1), 2u);
  EXPECT_EQ(publish(2), 2u);
  EXPECT_EQ(one.delivered, 2);
  EXPECT_EQ(two.delivered, 2);
  works = true;
  EXPECT_EQ(publish(3), 1u);
  EXPECT_EQ(publish(4), 1u);
  EXPECT_EQ(one.delivered, 2);
  EXPECT_EQ(watched.numbers, (std::vector<std::uint32_t>{1, 1, 1, 2}));
  EXPECT_EQ(group.counts().sent, 2u);
  EXPECT_EQ(group.counts().unsent, 2u);
}

TEST(Multicast, is_refused_by_a_server_without_a_group) {
  net::SimulatedNetwork network{5};
  Server server(network);
  ASSERT_TRUE(server.listen(kServed));
  TestClient client(network, kServed);
  EXPECT_EQ(outline(client.ask(group_question())), "NACK 250");
  EXPECT_EQ(outline(client.ask(group_request(1))), "NACK 253");
  EXPECT_EQ(outline(client.ask(group_request(0))), "ACK 253");
}

}  // namespace
}  // namespace playhouse::server
