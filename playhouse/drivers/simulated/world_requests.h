#pragma once

/// What clients ask of the world as a whole by setting properties of it: steps, to join those that it waits
/// for, a new start; and models that come and go (docs/lock-step.md).

#include "playhouse/device/driver.h"
#include "playhouse/drivers/simulated/simulation.h"
#include "playhouse/wire/generated/simulation.h"

namespace playhouse::drivers {

/// False, and `replier` is as it was: this is a property of another sort. Else it is answered, with ACK when
/// done, or with NACK and, as the property's value, one line that says why. Io thread. `caller` may be none.
bool ask_for_world(Simulation& simulation, const wire::simulation::PropertyReq& request,
                   device::Caller* caller, device::Replier& replier);

}  // namespace playhouse::drivers
