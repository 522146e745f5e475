#pragma once

/// Requests to the world as a whole, encoded as properties: lock-step membership
/// and steps, restart, spawn and removal of models (docs/lock-step.md).

#include "playhouse/bridge/simulated/overlap_warnings.h"
#include "playhouse/device/driver.h"
#include "playhouse/run/simulation.h"
#include "playhouse/wire/generated/simulation.h"

namespace playhouse::drivers {

/// False, with `replier` untouched, if it is another property. Otherwise replies: ACK when done,
/// or NACK with a one-line reason as the property's value. Io thread. `caller` may be null;
/// `overlaps` must outlive the requests.
bool ask_for_world(run::Simulation& simulation, const wire::simulation::PropertyReq& request,
                   device::Caller* caller, device::Replier& replier, OverlapWarnings& overlaps);

}  // namespace playhouse::drivers
