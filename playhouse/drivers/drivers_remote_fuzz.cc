// A Player server that says anything, in pieces, to whom uses its devices: passthrough, and `playhouse
// robot`. The first byte seeds the network's pieces; then a byte for each step, of which some take more:
// bytes that the server says, a message of one device, a request or a command to it.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "playhouse/base/assert.h"
#include "playhouse/base/fuzz_script.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/drivers/passthrough/remote_server.h"
#include "playhouse/net/simulated.h"
#include "playhouse/wire/header.h"

namespace playhouse::drivers {
namespace {

constexpr std::uint16_t kPort = 7000;
constexpr int kSteps = 256;

/// The other end: sends what it is told to.
class HostileServer final : private net::ConnectionEvents {
 public:
  explicit HostileServer(net::Network& network) {
    auto listener = network.listen("127.0.0.1", kPort, [this](std::unique_ptr<net::Connection> connection) {
      connection_ = std::move(connection);
      connection_->start(*this);
    });
    PLAYHOUSE_ASSERT(listener.ok());
    listener_ = std::move(*listener);
  }
  void say(std::span<const std::byte> bytes) {
    if (!connection_) return;
    const net::SharedBytes shared = std::make_shared<std::vector<std::byte>>(bytes.begin(), bytes.end());
    connection_->send(std::span(&shared, 1));
  }
  void hang_up() { connection_.reset(); }

 private:
  void received(std::span<const std::byte>) override {}
  void drained() override {}
  void lost() override {}
  void closed(const std::string&) override { connection_.reset(); }

  std::unique_ptr<net::Listener> listener_;
  std::unique_ptr<net::Connection> connection_;
};

/// Each request is answered once, and nothing comes without a connection.
class User final : public RemoteServer::RemoteServerEvents {
 public:
  explicit User(net::Network& network) : remote_(network, "lab", kPort, *this) {}
  ~User() override {
    remote_.disconnect();
    PLAYHOUSE_ASSERT(asked_ == heard_);
  }
  void connect() { remote_.connect(); }
  void disconnect() {
    remote_.disconnect();
    PLAYHOUSE_ASSERT(asked_ == heard_);
  }
  void open(RemoteDevice device) { remote_.open(device); }
  void close(RemoteDevice device) { remote_.close(device); }
  void command(RemoteDevice device, std::span<const std::byte> body) { remote_.command(device, 1, body); }
  void ask(RemoteDevice device, std::uint8_t subtype) {
    ++asked_;
    remote_.ask(device, subtype, {}, [this](bool, std::span<const std::byte> body) {
      PLAYHOUSE_ASSERT(body.size() <= limits::kBodyBytes);
      ++heard_;
    });
  }

 private:
  void connected() override { open({4, 0}); }
  void lost(const std::string& why) override { PLAYHOUSE_ASSERT(!why.empty() && asked_ == heard_); }
  void data(RemoteDevice, const wire::Header& header, std::span<const std::byte> body) override {
    PLAYHOUSE_ASSERT(remote_.is_connected() && body.size() == header.size);
  }
  void caught_up() override { PLAYHOUSE_ASSERT(remote_.is_connected()); }
  void opened(RemoteDevice, RemoteServer::RemoteOpening) override {
    PLAYHOUSE_ASSERT(remote_.is_connected());
  }
  void gone(RemoteDevice device) override {
    if (device.index % 2 == 1) remote_.disconnect();  // as a driver may, within an event
  }

  RemoteServer remote_;
  std::uint64_t asked_ = 0, heard_ = 0;
};

std::vector<std::byte> banner() {
  constexpr std::string_view kText = "Player v.3.1.1";
  std::vector<std::byte> bytes(limits::kBannerBytes);
  std::ranges::copy(std::as_bytes(std::span(kText)), bytes.begin());
  return bytes;
}

std::vector<std::byte> message(FuzzScript& script) {
  wire::Header header;
  header.interf = script.byte();
  header.index = script.byte();
  header.type = static_cast<wire::MessageType>(script.byte());
  header.subtype = script.byte();
  header.seq = script.byte();
  const std::span<const std::byte> body = script.take(script.byte());
  header.size = static_cast<std::uint32_t>(body.size());
  std::vector<std::byte> bytes(limits::kHeaderBytes);
  wire::encode_header(header, std::span<std::byte, limits::kHeaderBytes>(bytes.data(), limits::kHeaderBytes));
  bytes.insert(bytes.end(), body.begin(), body.end());
  return bytes;
}

void play(FuzzScript script) {
  net::SimulatedNetwork network(script.byte());
  network.window_bytes = 512;
  HostileServer server(network);
  User user(network);
  user.connect();
  network.run();
  for (int step = 0; step < kSteps && !script.done(); ++step) {
    switch (script.byte() % 11) {
      case 0:
        server.say(banner());
        break;
      case 1:
        server.say(script.take(script.byte()));
        break;
      case 2:
        server.say(message(script));
        break;
      case 3:
        server.hang_up();
        break;
      case 4:
        network.run_for(script.byte());
        break;
      case 5:
        user.connect();
        break;
      case 6:
        user.disconnect();
        break;
      case 7:
        user.open({4, script.byte()});
        break;
      case 8:
        user.close({4, script.byte()});
        break;
      case 9:
        user.ask({4, script.byte()}, script.byte());
        break;
      default:
        user.command({4, script.byte()}, script.take(script.byte()));
    }
    network.run();
  }
}

}  // namespace
}  // namespace playhouse::drivers

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  playhouse::log::silence();
  playhouse::drivers::play(playhouse::FuzzScript(std::as_bytes(std::span(data, size))));
  return 0;
}
