#pragma once

/// DrivenRobots: the robots that viewers drive by hand. A robot's wheels are open, as for a client that opens
/// its device, from the first velocity until the viewer lets go, leaves, or sends nothing for
/// limits::kViewerDriveSeconds; then they stop. Nothing is locked: the newest command counts, whoever gave
/// it. Thread: web.

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
  /// Who drives; only compared.
  using Driver = const void*;

  DrivenRobots(net::Network& network, world::Control& control) : network_(network), control_(control) {}

  /// The model has wheels; if it has gone by the time of the tick nothing happens.
  void drive(const replicate::Drive& drive, Driver driver);

  /// Stops what this driver was the last to drive.
  void left(Driver driver);

 private:
  struct Held {
    Driver driver = nullptr;
    std::shared_ptr<world::Use> use;  // the tick thread's once it is posted; none: its queue was full
    std::unique_ptr<net::Timer> deadline;
  };

  void hold_until_deadline(world::ModelId robot, Held& held);
  void let_go(world::ModelId robot);

  net::Network& network_;
  world::Control& control_;
  std::map<world::ModelId, Held> held_;
};

}  // namespace playhouse::web_server
