#pragma once

/// JoinedRobots: robots that clients add to the running world, and that leave it with them. Their sensors go
/// with them, also where somebody else takes a robot out. Io thread; the robots come and go on the tick
/// thread, as all changes.

#include <cstddef>
#include <map>
#include <memory>
#include <vector>

#include "playhouse/device/driver.h"
#include "playhouse/drivers/simulated/joining.h"
#include "playhouse/drivers/simulated/simulation.h"
#include "playhouse/wire/generated/simulation.h"

namespace playhouse::drivers {

class JoinedRobots {
 public:
  /// Before simulation.run().
  explicit JoinedRobots(Simulation& simulation);

  /// Adds a robot of the type `request.name`, as its value says, and ties it to the caller: it leaves when
  /// that has gone, however it went. ACK tells its name, NACK why not.
  void join(const wire::simulation::PropertyReq& request, device::Caller* caller, device::Replier replier);

 private:
  /// Of one client.
  struct Owned {
    std::size_t asked_for = 0;   // io thread
    std::vector<Joined> robots;  // tick thread
  };
  std::shared_ptr<Owned> owned_by(device::Caller& caller);
  /// Tick thread; by the robot.
  using Brought = std::map<world::ModelId, std::shared_ptr<Owned>>;
  static void follow(Simulation& simulation, Brought& brought, const world::Change& change);

  Simulation& simulation_;
  using Owners = std::map<const device::Caller*, std::shared_ptr<Owned>>;
  std::shared_ptr<Owners> owners_ = std::make_shared<Owners>();
  std::shared_ptr<Brought> brought_ = std::make_shared<Brought>();
};

}  // namespace playhouse::drivers
