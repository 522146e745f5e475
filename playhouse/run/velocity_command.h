#pragma once

/// The command that clients and the page have in common: a robot's velocity.

#include "playhouse/geom/pose.h"
#include "playhouse/run/inbox.h"

namespace playhouse::run {

/// Sets a velocity, if the robot still exists. Must be finite. [m/s, rad/s, in the robot's frame]
Change velocity_command(world::ModelId robot, const geom::Twist& velocity);

}  // namespace playhouse::run
