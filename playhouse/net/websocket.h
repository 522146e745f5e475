#pragma once

/// A WebSocket after its handshake: whole messages in both directions. http.h makes them. Everything is for
/// the io thread. Built on Boost.Beast, which stays in the .cc files.

#include <memory>
#include <string>
#include <string_view>

#include "playhouse/net/network.h"

namespace playhouse::net {

class WebSocketEvents {
 public:
  virtual ~WebSocketEvents() = default;
  /// One text message; `text` is valid for the call. Binary messages and messages over the limit close the
  /// socket.
  virtual void received(std::string_view text) = 0;
  /// The system has taken everything that was sent: messages_in_flight() is 0.
  virtual void drained() = 0;
  /// The peer closed or was lost. Comes once; nothing comes afterwards.
  virtual void closed(const std::string& why) = 0;
};

/// Destroying it closes it at once, and no event follows; destroying it inside an event is allowed.
class WebSocket {
 public:
  virtual ~WebSocket() = default;
  /// Begins to read. `events` must outlive the socket.
  virtual void start(WebSocketEvents& events) = 0;
  virtual void send_text(std::shared_ptr<const std::string> text) = 0;
  virtual void send_binary(SharedBytes bytes) = 0;
  /// Stops and continues reading; what the peer sends stays with the system, which slows it down.
  virtual void pause() = 0;
  virtual void resume() = 0;
  /// Messages given to send_*() that the system has not taken yet.
  virtual std::size_t messages_in_flight() const = 0;
  /// Closes with a reason (below 124 bytes), in the background. No more events.
  virtual void close(std::string reason) = 0;
  /// The other end as "address:port".
  virtual const std::string& peer() const = 0;
};

}  // namespace playhouse::net
