#pragma once

/// WatchedSensors: a selected robot's sensors measure while somebody looks at them, as if a client had opened
/// them. Thread: web.

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

  /// Those of these robots measure from now on, others no longer.
  void select(std::set<world::ModelId> robots);
  /// Asks nothing more of the world.
  void close() { retry_.reset(); }

 private:
  /// Subscriptions taken for a robot, so that exactly these are released.
  using Measuring = std::vector<world::Use>;

  void reconcile();
  bool begin(world::ModelId robot);
  bool end(const std::shared_ptr<Measuring>& uses);

  net::Network& network_;
  world::Control& control_;
  std::set<world::ModelId> selected_;
  std::map<world::ModelId, std::shared_ptr<Measuring>> begun_;  // that the world was asked for
  std::unique_ptr<net::Timer> retry_;
};

}  // namespace playhouse::web_server
