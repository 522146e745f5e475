#pragma once

/// A raw HTTP and WebSocket client for
/// tests, with frame handling of its own.

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace playhouse::net {

class WebClient {
 public:
  /// `host` (127.x.y.z) is the local address.
  explicit WebClient(std::uint16_t port, const std::string& host = "127.0.0.1")
      : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    EXPECT_EQ(::inet_pton(AF_INET, host.c_str(), &address.sin_addr), 1);
    EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }
  ~WebClient() { ::close(socket_); }
  WebClient(const WebClient&) = delete;
  WebClient& operator=(const WebClient&) = delete;

  /// The server has closed.
  bool ended() const { return ended_; }
  /// False: the server has closed.
  bool send(const std::string& bytes) {
    return ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL) == ssize_t(bytes.size());
  }
  /// Reads what has arrived; true if the server has closed.
  bool closed() {
    char buffer[4096];
    ssize_t count = 0;
    while ((count = ::recv(socket_, buffer, sizeof buffer, MSG_DONTWAIT)) > 0)
      in.append(buffer, static_cast<std::size_t>(count));
    return count == 0 || (errno != EAGAIN && errno != EINTR);
  }

  /// Reads until the predicate holds; false at end of stream or after five seconds.
  bool read_until(
      const std::function<bool(const std::string&)>& enough, const std::function<void()>& meanwhile = [] {}) {
    for (int rounds = 0; rounds < 500 && !enough(in); ++rounds) {
      meanwhile();
      pollfd waiting{socket_, POLLIN, 0};
      if (::poll(&waiting, 1, 10) <= 0) continue;
      char buffer[4096];
      const ssize_t count = ::recv(socket_, buffer, sizeof buffer, 0);
      ended_ = count <= 0;
      if (ended_) return enough(in);
      in.append(buffer, static_cast<std::size_t>(count));
    }
    return enough(in);
  }

  /// The whole reply to one request; the server closes afterwards.
  std::string ask(const std::string& request) {
    send(request);
    read_until([](const std::string&) { return false; });
    return in;
  }

  bool upgrade(const std::string& more = "") {
    ask_to_upgrade(more);
    return upgraded();
  }
  /// As a page whose link contains a token.
  bool upgrade_with(const std::string& token) {
    ask_to_upgrade("", "127.0.0.1", "?token=" + token);
    return upgraded();
  }
  /// As a page from `origin` that addresses the server as `host`.
  bool upgrade_at(const std::string& host, const std::string& origin) {
    ask_to_upgrade("Origin: " + origin + "\r\n", host);
    return upgraded();
  }
  void ask_to_upgrade(const std::string& more = "", const std::string& host = "127.0.0.1",
                      const std::string& query = "") {
    send("GET /live" + query + " HTTP/1.1\r\nHost: " + host +
         "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
         "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n" +
         more + "\r\n");
  }
  bool upgraded() {
    if (!read_until([](const std::string& text) { return text.find("\r\n\r\n") != std::string::npos; }))
      return false;
    const bool switched = in.starts_with("HTTP/1.1 101");
    in.erase(0, in.find("\r\n\r\n") + 4);
    return switched;
  }

  void send_text(const std::string& text) {
    std::string frame = "\x81";
    if (text.size() < 126) {
      frame += static_cast<char>(0x80 | text.size());
    } else {
      frame += static_cast<char>(0x80 | 126);
      frame += static_cast<char>(text.size() >> 8);
      frame += static_cast<char>(text.size() & 0xFF);
    }
    send(frame + std::string(4, '\0') + text);  // masked with zeros
  }

  /// The next complete message; its first byte is the WebSocket opcode. Empty: none.
  std::string message(const std::function<void()>& meanwhile = [] {}) {
    if (!read_until([this](const std::string&) { return message_bytes() != 0; }, meanwhile)) return {};
    const std::size_t bytes = message_bytes();
    std::string whole =
        std::string(1, static_cast<char>(in[0] & 0x0F)) + in.substr(head_bytes(), bytes - head_bytes());
    in.erase(0, bytes);
    return whole;
  }

  std::string in;

 private:
  std::size_t head_bytes() const {
    const int length = in[1] & 0x7F;
    return length < 126 ? 2 : length == 126 ? 4 : 10;
  }
  std::size_t message_bytes() const {
    if (in.size() < 2 || in.size() < head_bytes()) return 0;
    std::size_t length = in[1] & 0x7F;
    if (length > 125) {
      const std::size_t count = length == 126 ? 2 : 8;
      length = 0;
      for (std::size_t k = 0; k < count; ++k) length = length << 8 | static_cast<unsigned char>(in[2 + k]);
    }
    return in.size() < head_bytes() + length ? 0 : head_bytes() + length;
  }

  int socket_;
  bool ended_ = false;
};

}  // namespace playhouse::net
