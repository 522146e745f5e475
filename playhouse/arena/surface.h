#pragma once

/// Friction and restitution of materials.
///
/// In: the words of a model, its material, and what the file of its mesh says.
/// Out: friction and restitution.
/// Cost: a search for the name of the material in a short table.

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
