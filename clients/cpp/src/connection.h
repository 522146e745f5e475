#pragma once

/// One connection to a Player server: banner and framing; interprets only the header. Single-threaded.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "playhouse/wire/header.h"
#include "socket.h"

namespace playhouse::client {

struct Message {
  wire::Header header;
  std::vector<std::byte> body;
};

class Connection {
 public:
  /// Connects and reads the banner.
  static Result<Connection> open(const std::string& host, std::uint16_t port, Deadline deadline);

  const std::string& banner() const { return banner_; }
  const std::string& peer() const { return peer_; }
  std::uint16_t port() const { return port_; }
  bool is_open() const { return socket_.is_open(); }

  /// The body's size is filled into the header.
  Result<void> send(wire::Header header, std::span<const std::byte> body, Deadline deadline);

  /// The next message; none on timeout, when a partly read message is kept for the next call.
  Result<std::optional<Message>> receive(Deadline deadline);

  /// Whether a whole message is buffered, so that receive() returns without waiting.
  bool has_message() const;

  void close(Deadline deadline) { socket_.close(deadline); }

 private:
  Connection(Socket socket, std::string peer, std::uint16_t port)
      : socket_(std::move(socket)), peer_(std::move(peer)), port_(port) {}
  std::size_t unread() const { return bytes_.size() - start_; }
  Result<bool> fill(std::size_t count, Deadline deadline);
  void consume(std::size_t count);
  wire::Header peek_header() const;
  Error fault(const Error& error) const { return Error{peer_, error.text}; }

  Socket socket_;
  std::string peer_;
  std::string banner_;
  std::uint16_t port_;
  std::vector<std::byte> bytes_;  // from start_ on: read, but not yet taken
  std::size_t start_ = 0;
};

}  // namespace playhouse::client
