#pragma once

/// Data of devices by multicast: each message once, in a numbered datagram, for all clients that have asked for it
/// (docs/server.md). Datagrams get lost; the numbers, one series for each device, tell their readers. Io thread only.

#include <cstdint>
#include <memory>
#include <string>

#include "playhouse/base/result.h"
#include "playhouse/net/network.h"
#include "playhouse/server/fanout.h"

namespace playhouse::server {

/// Totals since the group was opened.
struct GroupCounts {
  std::uint64_t sent = 0, unsent = 0;  // messages; those that the system did not take
};

class MulticastGroup final : public ReaderGroup {
 public:
  /// Sends from the address of `bind`, which is not one of IPv6 alone.
  static Result<std::unique_ptr<MulticastGroup>> open(net::Network& network, const std::string& bind,
                                                      const net::Endpoint& group);
  /// `sender`: of `socket`, as place() tells it.
  MulticastGroup(std::unique_ptr<net::DatagramSocket> socket, const std::string& sender,
                 const net::Endpoint& group);

  /// Whether a datagram holds it.
  bool carries(const Frame& frame) const override;
  bool send(const Frame& frame, std::uint32_t number) override;

  /// "239.255.0.1:6680 from 10.0.0.7:41234", for clients: where to listen, and the sender, by which they know this
  /// server's datagrams from those of another one with the same group. Of a server with several addresses, which
  /// the system chooses from, the sender is its port alone.
  const std::string& place() const { return place_; }
  const GroupCounts& counts() const { return counts_; }

 private:
  const std::unique_ptr<net::DatagramSocket> socket_;
  const net::Endpoint group_;
  const std::string place_;
  GroupCounts counts_;
};

}  // namespace playhouse::server
