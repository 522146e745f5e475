#pragma once

/// ObserverClient: an observer with its socket: joins a server, keeps a replica
/// of the world up to date and calls back on events. Thread: that of the network.

#include <functional>
#include <memory>
#include <string>

#include "playhouse/base/result.h"
#include "playhouse/net/network.h"
#include "playhouse/replicate/datagrams/datagram_observer.h"

namespace playhouse::observers {

class ObserverClient {
 public:
  /// `turn` is called after every event and every timer tick; it may destroy
  /// the client. `bind` is the local address; "": any of the server's family.
  static Result<std::unique_ptr<ObserverClient>> open(net::Network& network, const net::Endpoint& server,
                                                      replicate::Terms wanted, std::string token,
                                                      std::function<void()> turn,
                                                      const std::string& bind = {});
  ObserverClient(const ObserverClient&) = delete;
  ObserverClient& operator=(const ObserverClient&) = delete;

  replicate::DatagramObserver& observer() { return observer_; }
  /// Ends the session.
  void leave();

 private:
  ObserverClient(net::Network& network, const net::Endpoint& server, replicate::Terms wanted,
                 std::string token, std::function<void()> turn);
  void received(const net::Endpoint& from, std::span<const std::byte> bytes);
  void look_at_clock();
  void send_due();

  net::Network& network_;
  const net::Endpoint server_;
  const std::function<void()> turn_;
  std::unique_ptr<net::DatagramSocket> socket_;
  std::unique_ptr<net::Timer> timer_;
  replicate::DatagramObserver observer_;
};

}  // namespace playhouse::observers
