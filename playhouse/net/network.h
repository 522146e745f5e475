#pragma once

/// What the server side needs of a network: listeners, connections, datagrams, tasks and timers on one io
/// thread. IoLoop is the real one (TCP and UDP), SimulatedNetwork the one of the tests. Knows bytes, never
/// messages. Everything runs on the io thread (the thread in IoLoop::run, or before it runs); only post() is
/// for any thread.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/net/endpoint.h"

namespace playhouse::net {

/// Immutable bytes that many connections may be sending at once. Owners: the sender's queue and each
/// connection that has not yet handed them to the system.
using SharedBytes = std::shared_ptr<const std::vector<std::byte>>;

inline constexpr int kConnectSeconds = 10;  // for a connection to be made
inline constexpr int kAliveSeconds = 30;    // without a sign of life of a peer that is expected to be alive

/// What a connection tells its owner.
class ConnectionEvents {
 public:
  virtual ~ConnectionEvents() = default;
  /// Bytes in order of arrival; `bytes` is valid for the call.
  virtual void received(std::span<const std::byte> bytes) = 0;
  /// The system has taken everything that was sent: in_flight_bytes() is 0.
  virtual void drained() = 0;
  /// Nothing that is sent reaches the peer any more: it was reset, or vanished. in_flight_bytes() is 0 from
  /// now on. Bytes that it sent before may still come, and closed() does. Comes once at most.
  virtual void lost() = 0;
  /// No more bytes will come. Comes once, after every byte that arrived. The peer may have shut down its
  /// sending half alone: it still reads, unless lost() came or comes.
  virtual void closed(const std::string& why) = 0;
};

/// A connected peer. Destroying it closes it at once, and no event follows; destroying it inside an event is
/// allowed.
class Connection {
 public:
  virtual ~Connection() = default;
  /// Begins to read. `events` must outlive the connection.
  virtual void start(ConnectionEvents& events) = 0;
  /// Sends the parts in order by one gathered write, behind what is in flight.
  virtual void send(std::span<const SharedBytes> parts) = 0;
  /// Bytes given to send() that the system has not taken yet.
  virtual std::size_t in_flight_bytes() const = 0;
  /// Stops and continues reading; unread bytes stay with the system, which slows the peer down. lost() comes
  /// all the same, closed() does not.
  virtual void pause() = 0;
  virtual void resume() = 0;
  /// In the background: flushes for up to 5 s, half-closes, then waits up to 1 s for the peer's close, so
  /// that one that still sends gets what it has not read. No more events.
  virtual void close_after_flush() = 0;
  /// From now on a peer that takes nothing of what is sent, or answers no probe, for kAliveSeconds is
  /// lost: unreachable or hung. Without it one that has much to read may take a quarter of
  /// an hour, and one that reads slowly is never lost.
  virtual void expect_alive() {}
  /// The other end as "address:port", for log lines.
  virtual const std::string& peer() const = 0;
};

/// An open port. Destroying it closes the port; connections it made live on.
class Listener {
 public:
  virtual ~Listener() = default;
  virtual std::uint16_t port() const = 0;
};

/// An open port for datagrams: each may come once, more than once, late, or never. Destroying it closes the
/// port; destroying it inside its receiver is allowed.
class DatagramSocket {
 public:
  /// `bytes` is valid for the call.
  using Receiver = std::function<void(const Endpoint& from, std::span<const std::byte> bytes)>;

  virtual ~DatagramSocket() = default;
  /// At once, or never: what the system has no room for is lost, as what a network loses.
  virtual void send(const Endpoint& to, std::span<const std::byte> bytes) = 0;
  virtual std::uint16_t port() const = 0;
};

/// Destroying it cancels the task.
class Timer {
 public:
  virtual ~Timer() = default;
};

/// A connection that is being made. Destroying it gives up.
class Attempt {
 public:
  virtual ~Attempt() = default;
};

class Network {
 public:
  using Task = std::function<void()>;
  using Acceptor = std::function<void(std::unique_ptr<Connection>)>;
  /// A connection, or why there is none.
  using Connected = std::function<void(Result<std::unique_ptr<Connection>>)>;

  virtual ~Network() = default;
  /// Runs the task on the io thread, in the order of the calls. Any thread.
  virtual void post(Task task) = 0;
  /// Runs the task once, `seconds` from now.
  [[nodiscard]] virtual std::unique_ptr<Timer> after(double seconds, Task task) = 0;
  /// Opens a TCP port (0: any free one). `bind` is a numeric IPv4 or IPv6 address or "localhost"; "0.0.0.0"
  /// means every IPv4 interface, "::" every interface of either kind.
  virtual Result<std::unique_ptr<Listener>> listen(const std::string& bind, std::uint16_t port,
                                                   Acceptor acceptor) = 0;
  /// Opens a UDP port, likewise.
  virtual Result<std::unique_ptr<DatagramSocket>> open_datagrams(const std::string& bind, std::uint16_t port,
                                                                 DatagramSocket::Receiver receiver) = 0;
  /// The network's clock: seconds from some moment on.
  virtual double now() const = 0;
  /// Connects to a TCP port of a host, by its name or numeric address. `connected` is called once, behind the
  /// call of connect(), after kConnectSeconds at the latest; never once the attempt is destroyed, which
  /// is allowed inside it.
  [[nodiscard]] virtual std::unique_ptr<Attempt> connect(const std::string& host, std::uint16_t port,
                                                         Connected connected) = 0;
};

}  // namespace playhouse::net
