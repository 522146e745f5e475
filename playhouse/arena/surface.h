#pragma once

/// What things are made of.

#include "playhouse/arena/rigid_body.h"
#include "playhouse/base/result.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::arena {

/// How the faces of a model rub and bounce: as its material does, or the file of its mesh says where it has
/// none, or as its word `friction` says. What is
/// made of nothing in particular is rubber on concrete with most others.
Surface surface_of(const scene::ModelDesc& desc);

/// That of the ground; fails for a material that is not known, with the nearest one that is.
Result<Surface> ground_of(const scene::SceneDesc& scene);

}  // namespace playhouse::arena
