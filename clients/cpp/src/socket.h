#pragma once

/// A TCP connection with deadlines, on plain POSIX sockets. One thread.

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

/// Now and `patience`; patience beyond a year counts as a year.
Deadline deadline_after(Seconds patience);

class Socket {
 public:
  /// Tries every address of the host. `host` is a name or a number.
  static Result<Socket> connect(const std::string& host, std::uint16_t port, Deadline deadline);

  Socket(Socket&& other) noexcept;
  Socket& operator=(Socket&& other) noexcept;
  ~Socket();

  bool is_open() const { return fd_ >= 0; }

  /// All of it, or an error that closes the socket: what was sent in part cannot be continued.
  Result<void> send(std::span<const std::byte> bytes, Deadline deadline);

  /// At least one byte into `out`; 0 when the deadline passes. An error, the peer's end included, closes the
  /// socket.
  Result<std::size_t> receive(std::span<std::byte> out, Deadline deadline);

  /// Ends the sending direction, waits until the peer has read everything and closed, or until the deadline,
  /// and closes. Closing with unread bytes at once would make TCP throw away what is still on its way: a last
  /// stop command, for instance.
  void close(Deadline deadline);

 private:
  explicit Socket(int fd) : fd_(fd) {}
  void drop();

  int fd_ = -1;
};

}  // namespace playhouse::client
