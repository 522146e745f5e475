#pragma once

/// Polled streams: byte streams of what joins machines, whose owners wait for them within a tick, unlike
/// Connection, which calls back. PolledNetwork makes them, waits for them and has their clock: the system's
/// (system_polled.h), or a simulated one (simulated_machines.h). Thread: the owner's.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "playhouse/base/result.h"

namespace playhouse::net {

/// A connected stream. The destructor closes it; what was sent still arrives.
class PolledStream {
 public:
  virtual ~PolledStream() = default;
  /// Sends the parts in order as far as there is room, without waiting. Returns the number of bytes, 0: there
  /// is none. Fails if the peer is gone.
  virtual Result<std::size_t> send(std::span<const std::span<const std::byte>> parts) = 0;
  /// Receives what has arrived, without waiting. Returns the number of bytes, 0: nothing has. Fails if the peer
  /// is gone, once all that it sent is received.
  virtual Result<std::size_t> receive(std::span<std::byte> out) = 0;
  /// "address:port" of the peer.
  virtual const std::string& peer() const = 0;
};

/// An open port. The destructor closes it; its streams stay open.
class PolledListener {
 public:
  virtual ~PolledListener() = default;
  virtual std::uint16_t port() const = 0;
  /// The next one that has connected; null: nobody has.
  virtual std::unique_ptr<PolledStream> accept() = 0;
};

/// What somebody waits for.
struct PollWish {
  PolledStream* stream = nullptr;
  bool reads = false, writes = false;  // bytes have arrived, or the peer is gone; there is room
};

class PolledNetwork {
 public:
  virtual ~PolledNetwork() = default;
  /// Monotonic seconds. Any thread.
  virtual double now() const = 0;
  /// Waits until a wish comes true, somebody has connected to `listener` (null: to none), or `until` [s; may
  /// be infinite]. False: the time is over. May return true too early.
  virtual bool wait(std::span<const PollWish> wishes, PolledListener* listener, double until) = 0;
  /// Connects within so many seconds to a port of a host, by name or numeric address.
  virtual Result<std::unique_ptr<PolledStream>> connect(const std::string& host, std::uint16_t port,
                                                        double seconds) = 0;
  /// Opens a port (0: any free one) at a numeric address.
  virtual Result<std::unique_ptr<PolledListener>> listen(const std::string& bind, std::uint16_t port) = 0;
};

}  // namespace playhouse::net
