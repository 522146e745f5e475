#pragma once

/// What keeps a scene from being run by any engine.

#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::stage {

/// Fails on a scene that no engine can run (an interval that is not positive, a kind without its description,
/// numbers that are not finite).
Result<void> check_scene(const scene::SceneDesc& scene);

/// What is odd about a scene in any engine, and what the engine in the plane measures less of than the file
/// asks for: lines as "file:line: text", of each kind one for the first.
std::vector<std::string> oddities_of(const scene::SceneDesc& scene);
std::vector<std::string> left_out_in_the_plane(const scene::SceneDesc& scene);

}  // namespace playhouse::stage
