#pragma once

/// From the names that a scene's models carry (`ctrl "wander"`) to controllers that decide for them.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/world/world.h"

namespace playhouse::controllers {

/// Where libraries of controllers are looked for, in order: the folder of the world file, those of
/// PLAYHOUSE_PATH and STAGEPATH (separated by colons), and `program_folder`.
std::vector<std::filesystem::path> library_folders(const scene::SceneDesc& scene,
                                                   const std::filesystem::path& program_folder);

/// Gives every model of the world the controllers that its `ctrl` names: built-ins first, then libraries in
/// `folders`. Call once, before the first tick; fills world.deciders and subscribes what the controllers use.
/// Gives the warnings, "file:line: text": demonstrations of Stage that this program has not got, a name given
/// twice.
/// Fails on the first name that is unknown, library that can't be used, or model that lacks what its
/// controller needs.
Result<std::vector<std::string>> attach(world::World& world, std::span<const std::filesystem::path> folders);

}  // namespace playhouse::controllers
