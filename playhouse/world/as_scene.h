#pragma once

/// The scene of a world as it stands, to be written as a world file (scene/write_world.h).

#include <string>

#include "playhouse/base/result.h"
#include "playhouse/scene/scene_desc.h"
#include "playhouse/world/world.h"

namespace playhouse::world {

/// Whoever is there, in the order of their ids, with their names, where they are, how they look, what they
/// say and how they are set. Paddles of grippers are as they stand; those on their way are as their file has
/// them. What is attached to a model is a part of it; who came has no controllers. All else is as the world's
/// scene says it, with which trees that are still alike share their descriptions. Default names are those
/// that a file gives them. A world that is made of it begins where this one is, at rest: what models do,
/// believe, measure and remember is in saved runs. `warnings` tells what a world file cannot say: tilts.
/// Cost: the population. Tick thread.
scene::SceneDesc as_scene(const World& world);

/// The text of a world file at `path` (scene::write_world()) of a scene as it stood at `time` [s], which a
/// comment tells. Any thread.
Result<std::string> world_file(const scene::SceneDesc& standing, double time, const std::string& path);

}  // namespace playhouse::world
