#pragma once

/// The page's side of a WebSocket (RFC 6455) for `bench watched`: blocking, and for our own server, which
/// sends every message in one frame. Beast's stream would take the compiler longer than all other benchmarks
/// together.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "playhouse/base/result.h"

namespace playhouse::app {

class PageSocket {
 public:
  /// Connects to /live of the server on this machine.
  static Result<PageSocket> connect(std::uint16_t port);
  PageSocket(PageSocket&& other) noexcept;
  PageSocket& operator=(PageSocket&&) = delete;
  ~PageSocket();

  Result<void> send_text(std::string_view text);

  struct PageMessage {
    bool binary = false;
    std::string_view bytes;  // until the next call
  };
  /// Waits for the next message.
  Result<PageMessage> next();

 private:
  explicit PageSocket(int socket) : socket_(socket) {}
  /// Reads until `count` bytes are there.
  Result<void> fill(std::size_t count);
  Result<void> send(std::string_view bytes);

  int socket_;
  std::string in_;         // received bytes
  std::size_t taken_ = 0;  // of them, returned before
};

}  // namespace playhouse::app
