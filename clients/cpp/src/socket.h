#pragma once

/// A connection by TCP or a Unix socket with deadlines, on POSIX sockets. Single-threaded.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "playhouse/base/result.h"

namespace playhouse::client {

using Clock = std::chrono::steady_clock;
using Deadline = Clock::time_point;
using Seconds = std::chrono::duration<double>;

/// Now plus `patience`, clamped to one year.
Deadline deadline_after(Seconds patience);

class Socket {
 public:
  /// Tries all addresses of the host in turn. `host` is a name, a numeric address, or "/FOLDER"
  /// for the Unix socket FOLDER/port.
  static Result<Socket> connect(const std::string& host, std::uint16_t port, Deadline deadline);

  Socket(Socket&& other) noexcept;
  Socket& operator=(Socket&& other) noexcept;
  ~Socket();

  bool is_open() const { return fd_ >= 0; }

  /// Sends all bytes, or closes the socket with an error: a partly sent message cannot be resumed.
  Result<void> send(std::span<const std::byte> bytes, Deadline deadline);

  /// Receives at least one byte into `out`; 0 on timeout. An error, end of stream included, closes the
  /// socket.
  Result<std::size_t> receive(std::span<std::byte> out, Deadline deadline);

  /// Half-closes the connection, waits until the peer has read everything and closed (or until the deadline),
  /// and closes. Closing at once with unread input would make TCP reset the connection and discard data in
  /// flight: e.g. a last stop command.
  void close(Deadline deadline);

 private:
  static Result<Socket> connect_unix(const std::string& path);
  explicit Socket(int fd) : fd_(fd) {}
  void drop();

  int fd_ = -1;
};

}  // namespace playhouse::client
