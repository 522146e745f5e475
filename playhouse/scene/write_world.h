#pragma once

/// SceneDesc -> text of a Stage 4 world file: the inverse of
/// world_loader.h. What equal models share is written once, as a macro.

#include <string>

#include "playhouse/base/result.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

/// The text of a file to be saved at `path`: bitmaps below its folder are referred to
/// relatively, others absolutely, and all absolutely if the path is empty. Loading it gives
/// the same scene: every tree with its names, descriptions and bodies, in order; lines,
/// comments, words without effect and default names of models that lost their names are not
/// kept. Bodies of models made in code are written as blocks. Fails, without a file name,
/// if the file would exceed the loader's limits on size or nesting (base/limits.h).
Result<std::string> write_world(const SceneDesc& scene, const std::string& path);

}  // namespace playhouse::scene
