#include "playhouse/server/websocket_connection.h"

#include <fmt/format.h>

#include <utility>

namespace playhouse::server {
namespace {

class WebSocketConnection final : public net::Connection, private net::WebSocketEvents {
 public:
  explicit WebSocketConnection(std::unique_ptr<net::WebSocket> socket)
      : socket_(std::move(socket)), peer_(socket_->peer()) {}

  void start(net::ConnectionEvents& events) override {
    events_ = &events;
    socket_->start(*this);
  }

  void send(std::span<const net::SharedBytes> parts) override {
    if (!socket_) return;
    for (const net::SharedBytes& part : parts) {
      if (part->empty()) continue;
      in_flight_ += part->size();
      socket_->send_binary(part);
    }
  }

  std::size_t in_flight_bytes() const override { return in_flight_; }
  void pause() override {
    if (socket_) socket_->pause();
  }
  void resume() override {
    if (socket_) socket_->resume();
  }
  void close_after_flush() override {
    if (socket_) socket_->close_after_flush("");
  }
  const std::string& peer() const override { return peer_; }

 private:
  std::size_t message_bytes() const override { return limits::kSocketMessageBytes; }

  bool received_bytes(std::span<const std::byte> bytes) override {
    events_->received(bytes);
    return true;
  }

  void received(std::string_view) override { end("sent a text message"); }

  void drained() override {
    in_flight_ = 0;
    events_->drained();
  }

  void closed(const std::string& why) override { end(why); }

  /// A WebSocket has no half-closed state: its peer reads no more.
  void end(const std::string& why) {
    in_flight_ = 0;
    const std::unique_ptr<net::WebSocket> ended = std::move(socket_);
    net::ConnectionEvents& events = *events_;
    events.lost();
    events.closed(why);
  }

  std::unique_ptr<net::WebSocket> socket_;  // null once closed
  const std::string peer_;
  net::ConnectionEvents* events_ = nullptr;
  std::size_t in_flight_ = 0;  // bytes
};

}  // namespace

std::unique_ptr<net::Connection> websocket_connection(std::unique_ptr<net::WebSocket> socket) {
  return std::make_unique<WebSocketConnection>(std::move(socket));
}

void accept_websocket(Server& server, std::uint16_t port, std::unique_ptr<net::WebSocket> socket) {
  if (!server.has_port(port)) return socket->close(fmt::format("this server has no port {}", port));
  server.accept(port, websocket_connection(std::move(socket)));
}

}  // namespace playhouse::server
