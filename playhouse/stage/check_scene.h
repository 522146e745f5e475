#pragma once

/// What keeps a scene from being run by any engine.

#include "playhouse/base/result.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::stage {

/// Fails on a scene that no engine can run (an interval that is not positive, a kind without its description,
/// numbers that are not finite). Warns in the log of walls that robots drive through.
Result<void> check_scene(const scene::SceneDesc& scene);

}  // namespace playhouse::stage
