#pragma once

/// SceneDesc -> the text of a Stage 4 world file: the reverse of world_loader.h. What models that are alike
/// have in common is said once, in a macro.

#include <string>

#include "playhouse/base/result.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

/// The text of a file that will be at `path`, from whose folder bitmaps below it are named; others are named
/// in full, and all where nobody knows the path, which is empty then. Loaded there, it is the same scene:
/// every tree with its names, descriptions and bodies, in order; lines, comments and words without any
/// meaning are not kept, nor default names of models that lost theirs to others. Bodies of models made in
/// code are written as their blocks. Fails, with a text that names no file, where the file would be larger,
/// or models in it deeper inside each other, than the loader takes (base/limits.h).
Result<std::string> write_world(const SceneDesc& scene, const std::string& path);

}  // namespace playhouse::scene
