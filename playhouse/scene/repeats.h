#pragma once

/// Which parts of world files say the same, so that the trees of a swarm are made and kept once.

#include <span>
#include <string>

#include "playhouse/scene/syntax.h"

namespace playhouse::scene {

/// A section at top level as one text, without the values of what each tree of the world has for itself:
/// name, pose, color and fiducial_return. Where no macro is defined between two sections of one key, they
/// make the same tree but for these, and the lines of what stands inside the section.
std::string repeat_key(const Section& section);

/// Whether two trees of descriptions, tops first, are the same but for what each tree of the world has for
/// itself and for lines, which are those of the first. A controller's is told to people, so it counts.
bool is_same_tree(std::span<const ModelDesc> a, std::span<const ModelDesc> b);

}  // namespace playhouse::scene
