#pragma once

/// From the names that custom models carry (`library "geiger 0.5"`) to the code of their libraries.

#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/libraries/libraries.h"
#include "playhouse/world/world.h"

namespace playhouse::libraries {

/// Loads the libraries of all custom models that the scene describes, each with a line in the log before, and
/// has those that are there begin. Call once, before the first tick; fills world.custom_codes. Gives the
/// warnings, "file:line: text", of libraries that are only found. Fails on the first model that names none,
/// one that can't or may not be used, or one that refuses its arguments.
Result<std::vector<std::string>> attach_custom_kinds(world::World& world, const Libraries& libraries);

}  // namespace playhouse::libraries
