#pragma once

/// ObserverServer: read-only replication of the world over datagrams (replicate/datagrams/datagram.h). Admits
/// observers after address validation and a check of their token, and sends each one deltas within its
/// budget. No cost without observers. docs/observers.md. Thread: that of the network, or before that runs.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "playhouse/base/limits.h"
#include "playhouse/base/result.h"
#include "playhouse/net/network.h"
#include "playhouse/replicate/snapshot_feed.h"
#include "playhouse/server/guests/guest_book.h"

namespace playhouse::observers {

struct ObserverOptions {
  std::string bind = "127.0.0.1";                                    // numeric address
  std::uint16_t port = 0;                                            // 0: any free one
  server::GuestBook guests;                                          // access list
  std::size_t observers = limits::kObservers;                        // at once
  std::uint32_t bytes_per_second = limits::kObserverBytesPerSecond;  // limit for each
};

struct ObserverStatus {
  std::size_t observers = 0;  // now
  std::uint64_t refused = 0;  // rejected with an answer
  std::uint64_t ignored = 0;  // datagrams that are invalid or of no session
  std::uint64_t datagrams_sent = 0, bytes_sent = 0;
};

class ObserverServer {
 public:
  /// The network and the feed must outlive the server. Construct it before the first tick; destroy it when the
  /// network has stopped and the feed is no longer shown.
  ObserverServer(net::Network& network, ObserverOptions options, replicate::SnapshotFeed& feed);
  ~ObserverServer();
  ObserverServer(const ObserverServer&) = delete;
  ObserverServer& operator=(const ObserverServer&) = delete;

  /// Opens the socket; returns the port.
  Result<std::uint16_t> listen();

  /// Ends the sessions of guests who were sent out.
  void end_sent_out();
  /// Ends all sessions with a reason.
  void say_goodbye(const std::string& why);

  ObserverStatus status() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace playhouse::observers
