#include "playhouse/arena/surface.h"

#include "playhouse/mesh/mesh.h"
#include "playhouse/scene/forms/materials.h"

namespace playhouse::arena {

ContactSurface surface_of(const scene::ModelDesc& desc) {
  const scene::NamedMaterial material = scene::material_of(desc);
  ContactSurface surface{material.friction, material.restitution};
  if (desc.material.empty() && desc.mesh && desc.mesh->physics) {
    surface.friction = desc.mesh->physics->friction.value_or(surface.friction);
    if (!desc.restitution)
      surface.restitution = desc.mesh->physics->restitution.value_or(surface.restitution);
  }
  if (desc.friction > 0) surface.friction = desc.friction;
  surface.share_x = desc.friction_x;
  surface.share_y = desc.friction_y;
  return surface;
}

ContactSurface ground_of(const scene::SceneDesc& scene) {
  const scene::NamedMaterial& material = scene::material_named(scene.ground);
  return {material.friction, material.restitution};
}

}  // namespace playhouse::arena
