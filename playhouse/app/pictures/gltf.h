#pragma once

#include <string>

#include "playhouse/base/result.h"
#include "playhouse/world/world.h"

namespace playhouse::app {

/// Exports the bodies of a world as a binary glTF 2.0 file (Khronos Group, glTF 2.0
/// Specification): a named node for each model, under its parent's node, and a mesh
/// for each distinct description of a body. Metres; y is up, as in glTF: the root
/// node rotates from our axes (x forward, y left, z up). Moving parts of models are
/// in their initial positions. Fails if the file would exceed limits::kGlbBytes.
Result<std::string> glb_of(const world::World& world);

}  // namespace playhouse::app
