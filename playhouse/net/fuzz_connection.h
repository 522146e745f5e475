#pragma once

/// For the fuzzers of net: an HTTP connection over a socket pair, both ends in one thread.

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "playhouse/base/assert.h"
#include "playhouse/net/asio.h"
#include "playhouse/net/asio_http.h"
#include "playhouse/net/http_places.h"

namespace playhouse::net {

class FuzzConnection {
 public:
  explicit FuzzConnection(HttpService& service) {
    int ends[2];
    PLAYHOUSE_ASSERT(socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends) == 0);
    peer_ = ends[0];
    asio::ip::tcp::socket socket(context_);
    socket.assign(asio::ip::tcp::v4(), ends[1]);
    serve_http({std::move(socket), "192.0.2.1:1", {}, false}, service, {}, std::make_shared<HttpPlaces>());
  }
  ~FuzzConnection() { hang_up(); }
  FuzzConnection(const FuzzConnection&) = delete;
  FuzzConnection& operator=(const FuzzConnection&) = delete;

  /// Polls the server once; the peer reads, unless stalled.
  void turn() {
    context_.restart();
    context_.poll();
    if (!stalled) read();
  }

  /// Bytes that the server does not accept, paused or closed, are dropped.
  void send(std::span<const std::byte> bytes) {
    for (int idle_turns = 0; !bytes.empty() && idle_turns < 2;) {
      const ssize_t count = ::send(peer_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (count < 0 && errno != EAGAIN) return;
      bytes = bytes.subspan(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
      idle_turns = count > 0 ? 0 : idle_turns + 1;
      turn();
    }
  }

  /// Half-closes: the peer sends nothing more.
  void finish() { ::shutdown(peer_, SHUT_WR); }
  void hang_up() {
    if (peer_ >= 0) ::close(peer_);
    peer_ = -1;
  }
  /// The server has closed the connection; it has no pending operations or timers.
  bool closed() const { return closed_; }
  bool forgotten() const { return context_.stopped(); }

  std::string received;
  bool stalled = false;  // the peer reads nothing

 private:
  void read() {
    char buffer[65536];
    ssize_t count = 0;
    while (peer_ >= 0 && (count = ::recv(peer_, buffer, sizeof buffer, 0)) > 0)
      received.append(buffer, static_cast<std::size_t>(count));
    if (count == 0) closed_ = true;
  }

  asio::io_context context_{1};
  int peer_;
  bool closed_ = false;
};

}  // namespace playhouse::net
