#pragma once

/// Implementation of IoLoop, shared by the .cc files of net for its io_context.

#include <array>
#include <functional>
#include <list>
#include <optional>

#include "playhouse/net/asio.h"
#include "playhouse/net/io_loop.h"
#include "playhouse/net/tls/tls_identity.h"

namespace playhouse::net {

struct IoLoop::Impl {
  asio::io_context context{1};
  std::optional<asio::signal_set> signals;
  std::function<void(int)> signal_task;
  /// Connections that have flushed and half-closed, and wait for
  /// their peers to close; each entry closes one. Oldest first.
  using Lingering = std::list<std::function<void()>>;
  Lingering lingering;
  /// Each entry gives up a handshake of TLS that has not ended. Oldest first.
  using Handshakes = std::list<std::function<void()>>;
  Handshakes handshakes;
  std::shared_ptr<TlsIdentity> tls;  // null: connections are in the clear
  bool finishing = false;            // stop once `lingering` is empty

  /// Adds an entry until leave(), which `end` calls too. Over limits::kLingering the oldest is closed.
  Lingering::iterator linger(std::function<void()> end);
  void leave(Lingering::iterator place);
  /// Closes all lingering connections to free file descriptors.
  void end_lingering();
  void end_first();

  /// Receive buffer shared by all connections; valid during one `received` call.
  std::array<std::byte, 65536> read_buffer;
};

}  // namespace playhouse::net
