#pragma once

/// What things are made of.

#include "playhouse/arena/rigid_body.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::arena {

/// How the faces of a model rub and bounce: as its material does, or as its word `friction` says. What is
/// made of nothing in particular is rubber on concrete with most others.
Surface surface_of(const scene::ModelDesc& desc);

}  // namespace playhouse::arena
