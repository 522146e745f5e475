#pragma once

/// Checks of a scene before any engine runs it.
///
/// In: a scene.
/// Out: an error, or warnings.
/// Cost: the models and their sensors.

#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::bodies {

/// Fails on a scene that no engine can run: an interval that is not
/// positive, a kind without its description, non-finite numbers.
Result<void> check_scene(const scene::SceneDesc& scene);

/// Warnings: oddities in any engine, and what the 2D engine leaves out of what the file
/// asks for. Lines as "file:line: text", for each kind of warning its first case only.
std::vector<std::string> oddities_of(const scene::SceneDesc& scene);
std::vector<std::string> left_out_in_the_plane(const scene::SceneDesc& scene);

}  // namespace playhouse::bodies
