// The whole server over real sockets of this machine, with drivers on another thread.

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <future>
#include <thread>

#include "playhouse/net/io_loop.h"
#include "playhouse/server/fake_driver.h"
#include "playhouse/server/server.h"
#include "playhouse/server/test_client.h"

namespace playhouse::server {
namespace {

constexpr std::uint16_t kWheels = 4;
constexpr std::uint8_t kGetGeom = 1;

/// A blocking client; every wait has a limit of ten seconds.
class Socket {
 public:
  explicit Socket(std::uint16_t port) : descriptor_(socket(AF_INET, SOCK_STREAM, 0)) {
    const timeval limit{10, 0};
    setsockopt(descriptor_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    connected_ = ::connect(descriptor_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  }
  ~Socket() { close(descriptor_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  /// The banner, read with one call as the client libraries do.
  std::string banner() {
    std::array<char, 64> buffer;
    const ssize_t count = recv(descriptor_, buffer.data(), buffer.size(), 0);
    return {buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
  }
  void send(const Bytes& bytes) {
    if (::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL) < 0) connected_ = false;
  }
  std::optional<Received> read() {
    std::array<std::byte, limits::kHeaderBytes> head;
    if (!fill(head)) return {};
    Received received{wire::decode_header(head), {}};
    received.body.resize(received.header.size);
    if (!fill(received.body)) return {};
    return received;
  }
  /// Says that it will send nothing more.
  void finish() { shutdown(descriptor_, SHUT_WR); }
  bool connected() const { return connected_; }

 private:
  bool fill(std::span<std::byte> to) {
    if (to.empty()) return true;
    return recv(descriptor_, to.data(), to.size(), MSG_WAITALL) == static_cast<ssize_t>(to.size());
  }
  int descriptor_;
  bool connected_ = false;
};

class ServerOnTcp : public ::testing::Test {
 protected:
  void SetUp() override {
    wheels.answers[kGetGeom] = Bytes(72);
    const Result<std::uint16_t> opened = server.listen(0);
    ASSERT_TRUE(opened) << opened.error().line();
    port = *opened;
    wheels_id = *server.add_device({port, kWheels, 0}, wheels);
    io = std::thread([this] { loop.run(); });
  }
  void TearDown() override {
    loop.stop();
    if (io.joinable()) io.join();
  }
  void publish(double time, std::size_t bytes = 52) {
    std::vector<device::Publication> batch;
    batch.push_back({wheels_id, 1, time, Bytes(bytes)});
    server.publish(std::move(batch));
  }

  FakeDriver wheels;
  net::IoLoop loop;
  Server server{loop};
  std::uint16_t port = 0;
  device::DeviceId wheels_id;
  std::thread io;
};

TEST_F(ServerOnTcp, greets_in_one_piece_and_answers) {
  Socket client(port);
  EXPECT_EQ(client.banner().size(), 32u);
  client.send(message(wire::MessageType::kReq, kWheels, 0, kGetGeom, {}, 77));
  const auto reply = client.read();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->header.type, wire::MessageType::kAck);
  EXPECT_EQ(reply->header.seq, 77u);
  EXPECT_EQ(reply->header.robot, port);
}

TEST_F(ServerOnTcp, delivers_every_message_of_another_thread_to_every_client) {
  constexpr int kClients = 20, kMessages = 200;
  std::vector<std::unique_ptr<Socket>> clients;
  for (int i = 0; i < kClients; ++i) {
    clients.push_back(std::make_unique<Socket>(port));
    EXPECT_EQ(clients.back()->banner().size(), 32u);
    clients.back()->send(open_request(kWheels, 0));
    ASSERT_TRUE(clients.back()->read());
  }
  std::thread tick([this] {
    for (int i = 0; i < kMessages; ++i) publish(i);
  });
  for (auto& client : clients) {
    for (int i = 0; i < kMessages; ++i) {
      const auto data = client->read();
      ASSERT_TRUE(data);
      EXPECT_EQ(data->header.timestamp, i);
    }
  }
  tick.join();
}

// As the thread of the ticks does it, for devices that live for a few ticks.
TEST_F(ServerOnTcp, delivers_what_devices_published_that_came_and_went_while_clients_read) {
  constexpr std::uint16_t kDevices = 2000, kPublished = 4;
  constexpr std::uint16_t kLaser = 6;
  FakeDriver driver;
  std::array<Socket, 2> clients{Socket(port), Socket(port)};
  for (Socket& client : clients) EXPECT_EQ(client.banner().size(), 32u);
  const auto on_io = [this](auto task) {
    std::promise<void> done;
    loop.post([&] {
      task();
      done.set_value();
    });
    done.get_future().wait();
  };
  for (std::uint16_t i = 0; i < kDevices; ++i) {
    device::DeviceId id;
    const auto index = static_cast<std::uint16_t>(i % 8);
    on_io([&] { id = *server.add_device({port, kLaser, index}, driver); });
    for (Socket& client : clients) {
      client.send(open_request(kLaser, index));
      const auto opened = client.read();
      ASSERT_TRUE(opened);
      ASSERT_EQ(access_of(*opened), 1);
    }
    for (int n = 0; n < kPublished; ++n) {
      std::vector<device::Publication> batch;
      batch.push_back({id, 1, 1.0 + n, Bytes(8)});
      server.publish(std::move(batch));
    }
    loop.post([this, id] { server.retire_device(id); });
    if (i % 2 == 0) {
      on_io([] {});  // it has retired
      std::vector<device::Publication> late;
      late.push_back({id, 1, 99.0, Bytes(8)});
      server.publish(std::move(late));
    }
    for (Socket& client : clients) {
      for (int n = 0; n < kPublished; ++n) {
        const auto data = client.read();
        ASSERT_TRUE(data);
        ASSERT_EQ(data->header.type, wire::MessageType::kData);
        ASSERT_EQ(data->header.timestamp, 1.0 + n);
      }
      const auto notice = client.read();
      ASSERT_TRUE(notice);
      ASSERT_EQ(access_of(*notice), 'e');
    }
  }
  on_io([&] { EXPECT_EQ(server.status().device_rows, 1u) << "the wheels"; });
}

TEST_F(ServerOnTcp, serves_others_while_one_client_does_not_read) {
  Socket stalled(port), good(port);
  for (Socket* client : {&stalled, &good}) {
    EXPECT_EQ(client->banner().size(), 32u);
    client->send(open_request(kWheels, 0));
    ASSERT_TRUE(client->read());
  }
  constexpr int kMessages = 400;
  for (int i = 0; i < kMessages; ++i) {
    publish(i, 1u << 20);
    const auto data = good.read();
    ASSERT_TRUE(data);
    EXPECT_EQ(data->header.timestamp, i);
  }
}

TEST_F(ServerOnTcp, carries_out_a_command_sent_just_before_the_socket_closes) {
  constexpr int kTimes = 20;
  for (int i = 0; i < kTimes; ++i) {
    Socket client(port);
    client.send(message(wire::MessageType::kCmd, kWheels, 0, 1, Bytes(28)));
  }  // the banner is left unread, so the close is a reset
  Socket last(port);
  EXPECT_EQ(last.banner().size(), 32u);
  while (true) {
    last.send(message(wire::MessageType::kReq, kWheels, 0, kGetGeom));
    ASSERT_TRUE(last.read());
    std::promise<std::size_t> sessions;
    loop.post([&] { sessions.set_value(server.status().sessions); });
    if (sessions.get_future().get() == 1) break;
  }
  TearDown();
  EXPECT_EQ(wheels.commands.size(), static_cast<std::size_t>(kTimes));
}

TEST_F(ServerOnTcp, gives_all_of_the_run_to_a_client_that_commands_all_the_time_and_reads_after_its_end) {
  constexpr int kMessages = 48;
  Socket client(port);
  EXPECT_EQ(client.banner().size(), 32u);
  client.send(open_request(kWheels, 0));
  ASSERT_TRUE(client.read());
  const Bytes command = message(wire::MessageType::kCmd, kWheels, 0, 1, Bytes(28));
  for (int i = 0; i < kMessages; ++i) {
    publish(i);
    client.send(command);
  }
  std::promise<void> ended;
  loop.post([&] {
    server.finish([&] {
      loop.finish();
      ended.set_value();
    });
  });
  ended.get_future().wait();
  for (int i = 0; i < kMessages; ++i) client.send(command);
  for (int i = 0; i < kMessages; ++i) {
    const auto data = client.read();
    ASSERT_TRUE(data) << i;
    EXPECT_EQ(data->header.timestamp, i);
  }
  EXPECT_FALSE(client.read());
  EXPECT_TRUE(client.connected());
  client.finish();
  io.join();  // the loop has ended by itself
}

TEST_F(ServerOnTcp, closes_the_session_of_an_absurd_frame_and_no_other) {
  Socket good(port), bad(port);
  EXPECT_EQ(good.banner().size(), 32u);
  EXPECT_EQ(bad.banner().size(), 32u);
  Bytes frame = message(wire::MessageType::kReq, kWheels, 0, kGetGeom);
  frame[36] = std::byte{0x7f};
  bad.send(frame);
  EXPECT_FALSE(bad.read());
  good.send(message(wire::MessageType::kReq, kWheels, 0, kGetGeom));
  EXPECT_TRUE(good.read());
}

}  // namespace
}  // namespace playhouse::server
