#pragma once

/// From the names that a scene's models carry (`ctrl "wander"`) to controllers that decide for them.

#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/libraries/libraries.h"
#include "playhouse/world/world.h"

namespace playhouse::controllers {

using libraries::Libraries;

/// Adds to a scene what its controllers make during a run: nothing comes that the scene does not describe.
/// Call before a world is made of it; once is enough.
void describe_for(scene::SceneDesc& scene);

/// Gives every model of the world the controllers that its `ctrl` names: built-ins first, then `libraries`,
/// each of which has a line in the log before it is loaded. Call once, before the first tick; fills
/// world.deciders and subscribes what the controllers use. Gives the warnings, "file:line: text": a name
/// given twice, a library that is only found. Fails on a name that is unknown, a library that can't or may
/// not be used, a model that lacks what its controller needs: on the first, and `others`, if given, gets
/// those of other controllers, one for each, up to limits::kWarningsOfAKind in all.
Result<std::vector<std::string>> attach(world::World& world, const Libraries& libraries,
                                        std::vector<Error>* others = nullptr);

}  // namespace playhouse::controllers
