#pragma once

/// Friction and restitution of materials.

#include "playhouse/arena/physics/rigid_body.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::arena {

/// The surface of a model: its words `friction` and `restitution` first,
/// else its material, else what the file of its mesh says. The
/// default is rubber on concrete with most other surfaces.
ContactSurface surface_of(const scene::ModelDesc& desc);

/// That of the ground.
ContactSurface ground_of(const scene::SceneDesc& scene);

}  // namespace playhouse::arena
