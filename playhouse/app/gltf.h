#pragma once

#include <string>

#include "playhouse/base/result.h"
#include "playhouse/world/world.h"

namespace playhouse::app {

/// The bodies of a world as a binary glTF 2.0 file (Khronos Group, glTF 2.0 Specification): a node for each
/// model, under the node of its parent and with its name, and a mesh for each description of a body that some
/// model has. Metres; y is up, as glTF has it: the node of the world turns everything so, and in it x is
/// forward, y left and z up as here. Parts that move with the state of their model are where they are at the
/// start. Fails on a world whose file would be larger than limits::kGlbBytes.
Result<std::string> glb_of(const world::World& world);

}  // namespace playhouse::app
