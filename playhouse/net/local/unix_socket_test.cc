// Unix sockets in place of ports. The truth: files of the folder, and connections of the system.

#include "playhouse/net/local/unix_socket.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <utility>

#include "playhouse/net/fair_share.h"
#include "playhouse/net/io_loop.h"
#include "playhouse/net/testing_bytes.h"

namespace playhouse::net {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

struct Kept final : ConnectionEvents {
  std::unique_ptr<Connection> connection;
  std::string bytes, end, fault;
  void received(std::span<const std::byte> part) override { bytes += text(part); }
  void drained() override {}
  void lost() override {}
  void closed(const std::string& why) override { end = why; }
  void keep(std::unique_ptr<Connection> made) {
    connection = std::move(made);
    connection->start(*this);
  }
};

class UnixSockets : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = ::testing::TempDir() + "unixXXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { fs::remove_all(folder); }

  Result<std::unique_ptr<Listener>> listen(std::uint16_t port) {
    return loop.listen(folder, port,
                       [this](std::unique_ptr<Connection> made) { server.keep(std::move(made)); });
  }
  std::unique_ptr<Attempt> connect(std::uint16_t port) {
    return loop.connect(folder, port, [this](Result<std::unique_ptr<Connection>> made) {
      if (!made) return static_cast<void>(client.fault = made.error().line());
      client.keep(std::move(*made));
    });
  }
  template <typename Condition>
  bool serve_until(Condition done) {
    for (int i = 0; i < 5000 && !done(); ++i) {
      const auto timer = loop.after(0.001, [this] { loop.stop(); });
      loop.run();
    }
    return done();
  }

  std::string folder;
  IoLoop loop;
  Kept server, client;
};

TEST_F(UnixSockets, carry_bytes_both_ways_and_name_the_process_of_their_peer) {
  const auto listener = listen(6665);
  ASSERT_TRUE(listener) << listener.error().line();
  EXPECT_EQ((*listener)->port(), 6665);
  EXPECT_TRUE(fs::is_socket(folder + "/6665"));
  const auto attempt = connect(6665);
  ASSERT_TRUE(serve_until([&] { return (client.connection && server.connection) || !client.fault.empty(); }));
  ASSERT_EQ(client.fault, "");
  EXPECT_EQ(server.connection->peer(), "unix:" + std::to_string(getpid()));
  EXPECT_TRUE(is_local(server.connection->peer()));
  EXPECT_TRUE(is_local(client.connection->peer()));
  const SharedBytes ping = shared("ping"), pong = shared("pong");
  client.connection->send(std::span(&ping, 1));
  server.connection->send(std::span(&pong, 1));
  ASSERT_TRUE(serve_until([&] { return server.bytes == "ping" && client.bytes == "pong"; }));
  client.connection.reset();
  ASSERT_TRUE(serve_until([&] { return !server.end.empty(); }));
}

TEST_F(UnixSockets, remove_their_file_but_not_another_one_of_that_name) {
  {
    const auto listener = listen(6665);
    ASSERT_TRUE(listener);
  }
  EXPECT_FALSE(fs::exists(folder + "/6665"));
  {
    const auto listener = listen(6665);
    ASSERT_TRUE(listener);
    fs::remove(folder + "/6665");
    std::ofstream(folder + "/other") << "a file";
    fs::rename(folder + "/other", folder + "/6665");
  }
  EXPECT_TRUE(fs::is_regular_file(folder + "/6665"));
}

TEST_F(UnixSockets, take_the_place_of_one_whose_program_has_ended_and_of_nothing_else) {
  Result<UnixListening> ended = listen_unix(folder, 6665);
  ASSERT_TRUE(ended);
  const auto refused = listen(6665);
  ASSERT_FALSE(refused) << "it is still served";
  EXPECT_THAT(refused.error().line(), HasSubstr("/6665: cannot listen: Address already in use"));
  close(ended->descriptor);
  const auto listener = listen(6665);
  EXPECT_TRUE(listener) << listener.error().line();

  std::ofstream(folder + "/6666") << "a file";
  EXPECT_FALSE(listen(6666));
  EXPECT_TRUE(fs::is_regular_file(folder + "/6666"));
}

TEST_F(UnixSockets, say_why_they_cannot_be_opened) {
  const auto fault = [this](std::uint16_t port) {
    client.fault.clear();
    const auto attempt = connect(port);
    EXPECT_EQ(client.fault, "") << "not before connect() returns";
    EXPECT_TRUE(serve_until([&] { return !client.fault.empty(); }));
    return client.fault;
  };
  EXPECT_THAT(fault(1), HasSubstr("/1: cannot connect: No such file or directory"));
  folder += "/none";
  EXPECT_THAT(listen(1).error().line(), HasSubstr("/none/1: cannot listen: No such file or directory"));
  folder = "/" + std::string(110, 'x');
  EXPECT_THAT(listen(1).error().line(), HasSubstr("invalid path of a socket: up to 107 bytes are valid"));
  EXPECT_THAT(fault(1), HasSubstr("invalid path of a socket"));
}

}  // namespace
}  // namespace playhouse::net
