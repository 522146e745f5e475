#pragma once

/// Sessions over UDP at a port, set up as the original's: an empty datagram begins a session, or begins it anew,
/// and is answered by the banner; what follows is the stream of TCP, a message in each datagram, or several.
/// Datagrams get lost: one that is whole messages never depends on an earlier one, data messages are numbered for
/// their readers, and what is lost here is counted. A command older than the last one of its client, by the
/// client's numbers, is dropped: it would overwrite a newer one. A sender may be forged: sessions by UDP have limits
/// of their own, within which they give way to each other. Io thread only.

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "playhouse/base/limits.h"
#include "playhouse/base/result.h"
#include "playhouse/net/network.h"

namespace playhouse::server {

/// Totals since the port was opened.
struct DatagramCounts {
  std::uint64_t received = 0;  // datagrams
  std::uint64_t dropped = 0;   // of these: of strangers, incomplete messages, or more than there is room for
  std::uint64_t late = 0;      // commands overtaken by newer messages of their client
  std::uint64_t sent = 0;      // messages
  std::uint64_t unsent = 0;    // messages that the system had no room for
  std::uint64_t too_long = 0;  // messages over limits::kDatagramMostBytes
  std::uint64_t silent = 0;    // sessions closed after limits::kDatagramSilentSeconds

  DatagramCounts& operator+=(const DatagramCounts& more);
};

/// What the sessions of all ports of a server may take, and take now.
struct DatagramRoom {
  std::size_t most_sessions = limits::kDatagramSessions;
  std::size_t most_bytes =
      limits::kInputBytes / 8;  // of unfinished messages, and of whole ones for busy sessions
  std::size_t sessions = 0, bytes = 0;
};

class DatagramPort {
 public:
  /// Opens the UDP port. Connections may outlive it, and are then without a line. `network` must outlive all of
  /// them.
  static Result<std::unique_ptr<DatagramPort>> open(net::Network& network, const std::string& bind,
                                                    std::uint16_t port, net::Network::Acceptor acceptor,
                                                    std::shared_ptr<DatagramRoom> room);
  ~DatagramPort();
  DatagramPort(const DatagramPort&) = delete;
  DatagramPort& operator=(const DatagramPort&) = delete;

  const DatagramCounts& counts() const;

  class Impl;  // shared with its connections

 private:
  explicit DatagramPort(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}
  std::shared_ptr<Impl> impl_;
};

}  // namespace playhouse::server
