#pragma once

/// Resolution of controller names of models (`ctrl "wander"`) to deciders.

#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/libraries/libraries.h"
#include "playhouse/world/world.h"

namespace playhouse::controllers {

using libraries::Libraries;

/// Adds descriptions of models that the scene's controllers may spawn: only
/// described models can be spawned. Call before a world is made from it; idempotent.
void describe_for(scene::SceneDesc& scene);

/// Attaches to every model the controllers in its `ctrl` words: built-ins first, then
/// `libraries`, each announced in the log before it is loaded. Call once, before the first tick;
/// fills world.deciders and subscribes what controllers use. Returns warnings, "file:line: text":
/// duplicate names, libraries that are only located. Fails on an unknown name, a library that
/// cannot or may not be used, a model that lacks what its controller needs; `others`, if given,
/// gets the errors of further controllers, one for each, up to limits::kWarningsOfAKind in total.
Result<std::vector<std::string>> attach(world::World& world, const Libraries& libraries,
                                        std::vector<Error>* others = nullptr);

}  // namespace playhouse::controllers
