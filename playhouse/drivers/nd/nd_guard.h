#pragma once

/// Limits a velocity by what the body would touch soon. A pure function; its arithmetic gives the same bits
/// on every machine.

#include "playhouse/drivers/nd/nd_diagram.h"
#include "playhouse/geom/pose.h"

namespace playhouse::drivers {

struct NdVelocity {
  double speed = 0;      // m/s, forward
  double turn_rate = 0;  // rad/s
};

/// The velocity with its speed reduced, down to 0, where the body would come too near to an obstacle within a
/// short time, and its turn rate 0 where the turn alone would. Moving away from obstacles is always allowed.
NdVelocity guarded(const NdDiagram& diagram, const geom::Box& body, const NdVelocity& wanted);

}  // namespace playhouse::drivers
