#pragma once

/// Export of a world's present state as a scene, to be written as a world file (scene/write_world.h).

#include <string>

#include "playhouse/base/result.h"
#include "playhouse/scene/scene_desc.h"
#include "playhouse/world/world.h"

namespace playhouse::world {

/// All models, in the order of their ids, with their names, poses, colours, texts and settings.
/// Paddles of grippers are at their present state; moving ones are as in their file. Attached
/// models are parts of their parents; models spawned at run time have no controllers. Everything
/// else is as in the world's scene, with which unchanged trees share their descriptions. Default
/// names are those that a file would give. A world made from it starts at rest in the present
/// configuration; velocities, odometry, measurements and controller memory are only in saved runs.
/// Tilts of up to 0.01 rad, as contacts leave them, are left out. Cost: the population. Tick thread.
scene::SceneDesc as_scene(const World& world);

/// The text of a world file at `path` (scene::write_world()) for the
/// state at `time` [s], which a comment in it states. Any thread.
Result<std::string> world_file(const scene::SceneDesc& standing, double time, const std::string& path);

}  // namespace playhouse::world
