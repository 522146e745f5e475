#pragma once

/// JoinedRobots: robots that clients spawn in the running world and that are removed when the
/// client disconnects. Their sensors are removed with them, even if another client removes the
/// robot. Io thread; spawns and removals run on the tick thread like all changes.

#include <cstddef>
#include <map>
#include <memory>
#include <vector>

#include "playhouse/bridge/simulated/joining.h"
#include "playhouse/device/driver.h"
#include "playhouse/run/simulation.h"
#include "playhouse/wire/generated/simulation.h"

namespace playhouse::drivers {

class JoinedRobots {
 public:
  /// Before simulation.run().
  explicit JoinedRobots(run::Simulation& simulation);

  /// Spawns a robot of type `request.name`, described by its value, and ties its
  /// lifetime to the caller's connection. ACK returns its name, NACK the reason.
  void join(const wire::simulation::PropertyReq& request, device::Caller* caller, device::Replier replier);

 private:
  /// Robots of one client.
  struct Owned {
    std::size_t asked_for = 0;   // io thread
    std::vector<Joined> robots;  // tick thread
  };
  std::shared_ptr<Owned> owned_by(device::Caller& caller);
  /// Tick thread; by robot.
  using Brought = std::map<world::ModelId, std::shared_ptr<Owned>>;
  static void follow(run::Simulation& simulation, Brought& brought, const world::Event& event);

  run::Simulation& simulation_;
  using Owners = std::map<const device::Caller*, std::shared_ptr<Owned>>;
  std::shared_ptr<Owners> owners_ = std::make_shared<Owners>();
  std::shared_ptr<Brought> brought_ = std::make_shared<Brought>();
};

}  // namespace playhouse::drivers
