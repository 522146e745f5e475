/// A page that sends any bytes and frames over its WebSocket, reads or not, and goes; and a viewer's server
/// that sends, pauses, closes and drops the socket at any moment. What is sent arrives whole and in order,
/// events come while they may, and in the end nothing of the connection is left.

#include <deque>
#include <memory>
#include <string>
#include <string_view>

#include "playhouse/base/assert.h"
#include "playhouse/base/fuzz_script.h"
#include "playhouse/base/limits.h"
#include "playhouse/net/fuzz_connection.h"

namespace playhouse::net {
namespace {

constexpr std::string_view kUpgrade =
    "GET /live HTTP/1.1\r\nHost: here\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n";
constexpr int kSteps = 256;

/// The server's end of it.
class Viewer final : public HttpService, public WebSocketEvents {
 public:
  Result<void> serves(const std::string&) override { return {}; }
  HttpReply get(const HttpRequest&) override { return {}; }
  Result<void> may_upgrade(const HttpRequest&) override { return {}; }
  void upgraded(std::unique_ptr<WebSocket> made, const HttpRequest&) override {
    socket = std::move(made);
    socket->start(*this);
  }

  void received(std::string_view text) override {
    PLAYHOUSE_ASSERT(socket && !over && text.size() <= limits::kViewerCommandBytes);
    if (drop_in_event) socket.reset();
  }
  void drained() override {
    PLAYHOUSE_ASSERT(socket && !over && socket->messages_in_flight() == 0);
    if (drop_in_event) socket.reset();
  }
  void closed(const std::string& why) override {
    PLAYHOUSE_ASSERT(socket && !over && !why.empty());
    over = true;
    if (drop_in_event) socket.reset();
  }

  std::unique_ptr<WebSocket> socket;
  bool over = false;  // closed by either side
  bool drop_in_event = false;
};

/// Opcode and payload, as they leave the server.
using Message = std::pair<int, std::string>;

/// What arrived is what was sent, from its beginning; pings, pongs and a close may stand in between.
void check(std::string_view bytes, const std::deque<Message>& sent) {
  bytes.remove_prefix(std::min(bytes.find("\r\n\r\n") + 4, bytes.size()));
  auto next = sent.begin();
  while (bytes.size() >= 2) {
    const int first = static_cast<unsigned char>(bytes[0]), opcode = first & 0x0F;
    PLAYHOUSE_ASSERT((first & 0xF0) == 0x80);  // whole, nothing reserved
    std::size_t length = static_cast<unsigned char>(bytes[1]), head = 2;
    PLAYHOUSE_ASSERT(length <= 127);  // a server masks nothing
    if (length > 125) {
      const std::size_t extra = length == 126 ? 2 : 8;
      if (bytes.size() < 2 + extra) return;
      length = 0;
      for (std::size_t k = 0; k < extra; ++k) length = length << 8 | static_cast<unsigned char>(bytes[2 + k]);
      head += extra;
    }
    const std::string_view payload = bytes.substr(head, length);
    if (opcode == 8) return;
    if (opcode < 8) {
      PLAYHOUSE_ASSERT(next != sent.end() && next->first == opcode && next->second.starts_with(payload));
      PLAYHOUSE_ASSERT(length == next->second.size());
      ++next;
    }
    bytes.remove_prefix(head + payload.size());
  }
}

class Session {
 public:
  explicit Session(FuzzScript script) : script_(script) {
    connection_.send(std::as_bytes(std::span(kUpgrade)));
    PLAYHOUSE_ASSERT(viewer_.socket);
  }

  void run() {
    for (int step = 0; step < kSteps && !script_.done(); ++step) {
      const std::uint8_t what = script_.byte();
      what < 0x80 ? peer_does(what % 6) : server_does(what % 6);
    }
    if (viewer_.socket && script_.byte() % 2) viewer_.socket->close("the end");
    connection_.stalled = false;
    connection_.turn();
    check(connection_.received, sent_);
    connection_.hang_up();
    connection_.turn();
    viewer_.socket.reset();
    for (int k = 0; k < 3; ++k) connection_.turn();
    PLAYHOUSE_ASSERT(connection_.forgotten());
  }

 private:
  void peer_does(int what) {
    switch (what) {
      case 0:
        return connection_.send(script_.take(script_.byte()));
      case 1:
      case 2:
        return send_frame();
      case 3:
        connection_.stalled = !connection_.stalled;
        return;
      case 4:
        return connection_.finish();
      default:
        return connection_.turn();
    }
  }

  /// Any opcode and flags, masked with zeros, its length as told or as it is.
  void send_frame() {
    std::string frame(1, static_cast<char>(script_.byte()));
    const std::uint8_t length = script_.byte();
    const auto payload = script_.take(length % 128);
    frame += static_cast<char>(length < 128 ? 0x80 | payload.size() : length);
    if (frame[1] == '\xFE') frame += {'\0', static_cast<char>(payload.size())};
    frame += std::string(4, '\0');
    frame.append(reinterpret_cast<const char*>(payload.data()), payload.size());
    connection_.send(std::as_bytes(std::span(frame)));
  }

  void server_does(int what) {
    if (!viewer_.socket) return connection_.turn();
    switch (what) {
      case 0:
        return send(1);
      case 1:
        return send(2);
      case 2:
        return script_.byte() % 2 ? viewer_.socket->pause() : viewer_.socket->resume();
      case 3:
        viewer_.socket->close(std::string(script_.byte() % 124, 'r'));
        viewer_.over = true;
        return;
      case 4:
        viewer_.socket.reset();
        return;
      default:
        viewer_.drop_in_event = true;
        return;
    }
  }

  void send(int opcode) {
    const std::size_t root = script_.byte();
    std::string payload(root * root, static_cast<char>('a' + root % 26));
    if (!viewer_.over) sent_.emplace_back(opcode, payload);
    if (opcode == 1)
      return viewer_.socket->send_text(std::make_shared<const std::string>(std::move(payload)));
    const auto bytes = std::as_bytes(std::span(payload));
    viewer_.socket->send_binary(std::make_shared<const std::vector<std::byte>>(bytes.begin(), bytes.end()));
  }

  FuzzScript script_;
  Viewer viewer_;
  FuzzConnection connection_{viewer_};
  std::deque<Message> sent_;
};

}  // namespace
}  // namespace playhouse::net

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  playhouse::net::Session(playhouse::FuzzScript(std::as_bytes(std::span(data, size)))).run();
  return 0;
}
