#pragma once

/// ObserverServer: the world for those who only look, by datagrams (replicate/datagram.h). Lets observers in
/// after their address is proven and their token is a guest's, and sends each what changes within its budget.
/// Costs nothing while nobody observes. docs/observers.md. Threads: wants_show() and show() are for the tick
/// thread or one that works for it, all else for the thread of the network or for before it runs.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "playhouse/base/limits.h"
#include "playhouse/base/result.h"
#include "playhouse/net/network.h"
#include "playhouse/replicate/layout.h"
#include "playhouse/web_server/guests.h"
#include "playhouse/world/control.h"

namespace playhouse::observers {

struct ObserverOptions {
  std::string bind = "127.0.0.1";                                    // numeric address
  std::uint16_t port = 0;                                            // 0: any free one
  web_server::GuestBook guests;                                      // who may come
  std::size_t observers = limits::kObservers;                        // at once
  std::uint32_t bytes_per_second = limits::kObserverBytesPerSecond;  // to each at most
};

struct ObserverStatus {
  std::size_t observers = 0;  // now
  std::uint64_t refused = 0;  // who was answered that it may not
  std::uint64_t ignored = 0;  // datagrams that were none of ours, or of nobody
  std::uint64_t datagrams_sent = 0, bytes_sent = 0;
};

class ObserverServer {
 public:
  /// Reads the world at once, so the first tick comes after; `devices` is asked now, and later by show() for
  /// models that come. The network and the scene outlive the server; destroy it when the network no longer
  /// runs and show() is no longer called.
  ObserverServer(net::Network& network, ObserverOptions options, const world::World& world,
                 replicate::DeviceNames devices);
  ~ObserverServer();
  ObserverServer(const ObserverServer&) = delete;
  ObserverServer& operator=(const ObserverServer&) = delete;

  /// Opens the port and returns its number.
  Result<std::uint16_t> listen();

  /// As of web_server::WebServer.
  bool wants_show() const;
  void show(const world::World& world, const world::Pace& pace);

  /// Tells all observers that it is over.
  void say_goodbye(const std::string& why);

  ObserverStatus status() const;

 private:
  class Impl;
  std::shared_ptr<Impl> impl_;  // with the tasks posted to the network, which may outlive the server
};

}  // namespace playhouse::observers
