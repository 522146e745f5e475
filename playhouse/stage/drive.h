#pragma once

/// Drive models: turns the command of every robot into a velocity in its own frame, within its bounds.

#include "playhouse/world/workers.h"
#include "playhouse/world/world.h"

namespace playhouse::stage {

/// The phase `act`: writes positions.velocity. Robots that nobody subscribed, or whose motors are off, stand
/// still.
void act(world::World& world, world::Workers& workers);

}  // namespace playhouse::stage
