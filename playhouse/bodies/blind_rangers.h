#pragma once

/// Rangers whose beams pass above or below everything: walls of 0.1 m under a scanner at 0.3 m.
///
/// In: a world.
/// Out: lines for the log.

#include <string>
#include <vector>

#include "playhouse/world/world.h"

namespace playhouse::bodies {

/// A line "file:line: ..." for the first ranger of which no beam is at the height of a body of another tree,
/// with the number of further ones; none in worlds without other bodies, and with more than 10,000 rangers.
/// Sensors with several rings are left out. Cost: the models, times the different heights of sensors.
std::vector<std::string> blind_rangers(const world::World& world);

}  // namespace playhouse::bodies
