#pragma once

/// A WebSocket after its handshake: whole messages in both directions; made by
/// http.h. Io thread only. Built on Boost.Beast, which stays in the .cc files.

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "playhouse/base/limits.h"
#include "playhouse/net/network.h"

namespace playhouse::net {

class WebSocketEvents {
 public:
  virtual ~WebSocketEvents() = default;
  /// A text message; `text` is valid during the call. Messages over message_bytes() close the socket.
  virtual void received(std::string_view text) = 0;
  /// A binary message, likewise. False: not taken, which closes the socket.
  virtual bool received_bytes(std::span<const std::byte>) { return false; }
  virtual std::size_t message_bytes() const { return limits::kViewerCommandBytes; }
  /// The system has accepted everything sent: messages_in_flight() is 0.
  virtual void drained() = 0;
  /// The peer has closed or was lost. Called once, as the last event.
  virtual void closed(const std::string& why) = 0;
};

/// The destructor closes it at once, without further events; it may be destroyed inside an event.
class WebSocket {
 public:
  virtual ~WebSocket() = default;
  /// Starts reading. `events` must outlive the socket.
  virtual void start(WebSocketEvents& events) = 0;
  virtual void send_text(std::shared_ptr<const std::string> text) = 0;
  virtual void send_binary(SharedBytes bytes) = 0;
  /// Pauses and resumes reading: back-pressure on the peer.
  virtual void pause() = 0;
  virtual void resume() = 0;
  /// Messages passed to send_*() that the system has not accepted yet.
  virtual std::size_t messages_in_flight() const = 0;
  /// Closes with a reason (below 124 bytes), in the background. No more events.
  virtual void close(std::string reason) = 0;
  /// The same after flushing for up to kFlushSeconds.
  virtual void close_after_flush(std::string reason) = 0;
  /// Remote "address:port".
  virtual const std::string& peer() const = 0;
};

}  // namespace playhouse::net
