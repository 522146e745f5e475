#pragma once

/// SimulatedPage: a page of a simulated network that has asked for a WebSocket: whole messages in both
/// directions, delayed and cut like bytes of connections. A handle: copies refer to the same page.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/net/network.h"

namespace playhouse::net {

struct SimulatedSocket;

class SimulatedPage {
 public:
  struct SocketMessage {
    bool is_text = false;
    std::vector<std::byte> bytes;
  };

  explicit SimulatedPage(std::shared_ptr<SimulatedSocket> socket) : socket_(std::move(socket)) {}

  void send(std::string_view text);
  void send(SocketMessage message);
  /// Closes; the server still gets what was sent.
  void finish();
  /// Vanishes silently: what is on its way in either direction is lost.
  void vanish();
  /// Stops reading: the server's messages fill the window, then stay in flight.
  void stall();
  void read_on();
  /// Everything received so far; clears it.
  std::vector<SocketMessage> take();
  /// Why the server has refused or closed the WebSocket; none: it has not.
  const std::optional<std::string>& closed() const;

 private:
  std::shared_ptr<SimulatedSocket> socket_;
};

}  // namespace playhouse::net
