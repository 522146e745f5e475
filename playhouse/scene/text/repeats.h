#pragma once

/// Detection of repeated trees in world files, so that those of a swarm are parsed and stored once.

#include <span>
#include <string>

#include "playhouse/config/text/syntax.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

/// Canonical text of a top-level section without per-tree values: name, pose, color
/// and fiducial_return. Two sections with equal keys and no macro definition between
/// them make equal trees except for those values and the line numbers inside.
std::string repeat_key(const config::Section& section);

/// True if two trees of descriptions, roots first, are equal except for per-tree
/// values and line numbers. A controller's line counts, since it is shown to users.
bool is_same_tree(std::span<const ModelDesc> a, std::span<const ModelDesc> b);

}  // namespace playhouse::scene
