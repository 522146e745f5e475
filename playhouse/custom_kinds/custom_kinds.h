#pragma once

/// Resolution of custom models' libraries (`library "geiger 0.5"`) to their code.

#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/libraries/libraries.h"
#include "playhouse/world/world.h"

namespace playhouse::custom_kinds {

/// Loads the libraries of all custom models in the scene, each announced in the log, and
/// initialises existing models. Call once, before the first tick; fills world.custom_codes. Returns
/// warnings, "file:line: text", for libraries that are only located. Fails on the first model
/// without a library, with one that cannot or may not be loaded, or that rejects its arguments.
Result<std::vector<std::string>> attach_custom_kinds(world::World& world,
                                                     const libraries::Libraries& libraries);

}  // namespace playhouse::custom_kinds
