#pragma once

/// Network abstraction of the server side: listeners, connections, datagrams, pages,
/// tasks and timers on one io thread. Implementations: IoLoop (TCP and UDP),
/// SimulatedNetwork (tests). Transports bytes, knows no messages. Everything is
/// for the io thread (in IoLoop::run, or before it), except post(): any thread.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/net/endpoint.h"
#include "playhouse/net/serial/serial_line.h"

namespace playhouse::net {

/// Immutable bytes that several connections may send. Owners: the sender's
/// queue and each connection that has not passed them to the system yet.
using SharedBytes = std::shared_ptr<const std::vector<std::byte>>;

inline constexpr int kConnectSeconds = 10;  // timeout of connecting
inline constexpr int kAliveSeconds = 30;    // timeout for a dead peer, with expect_alive()
inline constexpr int kFlushSeconds = 5;     // timeout of flushing before a close

class HttpService;
class TlsTrust;

/// Callbacks of a connection.
class ConnectionEvents {
 public:
  virtual ~ConnectionEvents() = default;
  /// Bytes in order of arrival; `bytes` is valid during the call.
  virtual void received(std::span<const std::byte> bytes) = 0;
  /// The system has accepted everything sent: in_flight_bytes() is 0.
  virtual void drained() = 0;
  /// The peer is unreachable for sending: reset or vanished. in_flight_bytes() is 0 from now
  /// on. Bytes sent by it before may still arrive, and closed() follows. Called at most once.
  virtual void lost() = 0;
  /// End of input. Called once, after all bytes received. The peer may
  /// have half-closed only: it still reads, unless lost() is called.
  virtual void closed(const std::string& why) = 0;
};

/// A connected peer. The destructor closes it at once, without
/// further events; it may be destroyed inside an event.
class Connection {
 public:
  virtual ~Connection() = default;
  /// Starts reading. `events` must outlive the connection.
  virtual void start(ConnectionEvents& events) = 0;
  /// Appends the parts to the send queue, in order, with one gathered write.
  virtual void send(std::span<const SharedBytes> parts) = 0;
  /// Bytes passed to send() that the system has not accepted yet.
  virtual std::size_t in_flight_bytes() const = 0;
  /// Pauses and resumes reading: back-pressure on the peer by TCP flow
  /// control. lost() is still reported while paused, closed() is not.
  virtual void pause() = 0;
  virtual void resume() = 0;
  /// In the background: flushes for up to 5 s, half-closes, then waits up to 1 s for the
  /// peer's close, so that a peer that is still sending receives everything. No more events.
  virtual void close_after_flush() = 0;
  /// Enables dead peer detection: a peer that acknowledges neither data nor
  /// probes for kAliveSeconds is lost. Without it a peer with unread data may
  /// take a quarter of an hour to time out, and a slow reader is never lost.
  virtual void expect_alive() {}
  /// Remote "address:port", for the log.
  virtual const std::string& peer() const = 0;
};

/// An open port. The destructor closes it; its connections stay open.
class Listener {
 public:
  virtual ~Listener() = default;
  virtual std::uint16_t port() const = 0;
};

/// An open UDP port: datagrams may be lost, duplicated, delayed or reordered.
/// The destructor closes it; it may be destroyed inside its receiver.
class DatagramSocket {
 public:
  /// `bytes` is valid during the call.
  using Receiver = std::function<void(const Endpoint& from, std::span<const std::byte> bytes)>;

  virtual ~DatagramSocket() = default;
  /// Sends at once. False: the system has no room, or the datagram is too long, and it is lost.
  virtual bool send(const Endpoint& to, std::span<const std::byte> bytes) = 0;
  /// Calls `refused` when the machine of a peer says that no program has its port (ICMP). Call once.
  virtual void on_refused(std::function<void(const Endpoint& peer)> refused) = 0;
  virtual std::uint16_t port() const = 0;
};

/// Destroying it cancels the task.
class Timer {
 public:
  virtual ~Timer() = default;
};

/// A pending connection. The destructor cancels it.
class Attempt {
 public:
  virtual ~Attempt() = default;
};

class Network {
 public:
  using Task = std::function<void()>;
  using Acceptor = std::function<void(std::unique_ptr<Connection>)>;
  /// A connection, or an error.
  using Connected = std::function<void(Result<std::unique_ptr<Connection>>)>;

  virtual ~Network() = default;
  /// Runs the task on the io thread, in the order of the calls. Any thread.
  virtual void post(Task task) = 0;
  /// Runs the task once, `seconds` from now.
  [[nodiscard]] virtual std::unique_ptr<Timer> after(double seconds, Task task) = 0;
  /// Opens a TCP port (0: any free one). `bind` is a numeric IPv4 or IPv6 address or "localhost"; "0.0.0.0"
  /// means every IPv4 interface, "::" every interface of either kind. A folder, "/FOLDER", opens the Unix
  /// socket FOLDER/port instead, which its Listener removes; peers are "unix:PROCESS" then.
  virtual Result<std::unique_ptr<Listener>> listen(const std::string& bind, std::uint16_t port,
                                                   Acceptor acceptor) = 0;
  /// Serves HTTP and WebSockets (http.h) on a TCP port, likewise. `service` must outlive the network's run.
  virtual Result<std::unique_ptr<Listener>> listen_http(const std::string& bind, std::uint16_t port,
                                                        HttpService& service) = 0;
  /// Opens a UDP port, likewise. What is sent to a group goes one hop, and out by the interface of `bind`.
  virtual Result<std::unique_ptr<DatagramSocket>> open_datagrams(const std::string& bind, std::uint16_t port,
                                                                 DatagramSocket::Receiver receiver) = 0;
  /// Clock of the network: monotonic seconds. Any thread.
  virtual double now() const = 0;
  /// Connects to a TCP port of a host, by name, numeric address or "/FOLDER". `connected`
  /// is called once, after connect() has returned, within kConnectSeconds;
  /// never after the attempt's destruction, which is allowed inside it.
  [[nodiscard]] virtual std::unique_ptr<Attempt> connect(const std::string& host, std::uint16_t port,
                                                         Connected connected) = 0;
  /// The same to a port that speaks TLS, within twice that time; fails unless its certificate is for `host`
  /// and trusted. A network without TLS connects in the clear: simulated ones have none.
  [[nodiscard]] virtual std::unique_ptr<Attempt> connect_tls(const std::string& host, std::uint16_t port,
                                                             std::shared_ptr<TlsTrust> trust,
                                                             Connected connected);
  /// Opens a serial port of this machine, "/dev/ttyUSB0", for this program alone.
  virtual Result<std::unique_ptr<SerialLine>> open_serial(const std::string& path,
                                                          const SerialSettings& settings);
  /// Makes a pseudo-terminal, which other programs open as a serial port by the link `link`; it is removed with the line.
  /// `settings` are those that it begins with. A network that has no serial lines fails in both.
  virtual Result<std::unique_ptr<SerialLine>> open_terminal(const std::string& link,
                                                            const SerialSettings& settings);
};

}  // namespace playhouse::net
