#pragma once

/// DrivenRobots: the robots that viewers drive by hand. A robot is subscribed, as
/// by a client that opens its device, from the first velocity until the viewer
/// releases it, leaves, or sends nothing for limits::kViewerDriveSeconds; then it
/// stops. No locking: the latest command from anyone applies. Thread: web.

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "playhouse/net/network.h"
#include "playhouse/replicate/command.h"
#include "playhouse/world/control.h"

namespace playhouse::web_server {

class DrivenRobots {
 public:
  /// Identity of a viewer; compared only.
  using DrivingViewer = const void*;

  DrivenRobots(net::Network& network, world::Control& control) : network_(network), control_(control) {}

  /// The model must have a drive; no effect if it is removed before the tick.
  void drive(const replicate::Drive& drive, DrivingViewer driver);

  /// Stops the robots last driven by this viewer.
  void left(DrivingViewer driver);

 private:
  struct Held {
    DrivingViewer driver = nullptr;
    std::shared_ptr<world::Use> use;  // owned by the tick thread once posted; null: its queue was full
    std::unique_ptr<net::Timer> deadline;
  };

  void hold_until_deadline(world::ModelId robot, Held& held);
  void let_go(world::ModelId robot);

  net::Network& network_;
  world::Control& control_;
  std::map<world::ModelId, Held> held_;
};

}  // namespace playhouse::web_server
