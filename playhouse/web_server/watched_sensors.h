#pragma once

/// WatchedSensors: subscribes the sensors of robots that viewers
/// have selected, as if a client had opened them. Thread: web.

#include <map>
#include <memory>
#include <set>
#include <vector>

#include "playhouse/net/network.h"
#include "playhouse/world/control.h"

namespace playhouse::web_server {

class WatchedSensors {
 public:
  WatchedSensors(net::Network& network, world::Control& control) : network_(network), control_(control) {}

  /// Subscribes the sensors of these robots and unsubscribes all others.
  void select(std::set<world::ModelId> robots);
  /// Stops retrying.
  void close() { retry_.reset(); }

 private:
  /// The subscriptions taken for a robot, so that exactly those are released.
  using Measuring = std::vector<world::Use>;

  void reconcile();
  bool begin(world::ModelId robot);
  bool end(const std::shared_ptr<Measuring>& uses);

  net::Network& network_;
  world::Control& control_;
  std::set<world::ModelId> selected_;
  std::map<world::ModelId, std::shared_ptr<Measuring>> begun_;  // with subscriptions requested
  std::unique_ptr<net::Timer> retry_;
};

}  // namespace playhouse::web_server
