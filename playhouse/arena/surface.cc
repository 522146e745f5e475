#include "playhouse/arena/surface.h"

#include <array>
#include <string_view>
#include <vector>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/mesh/mesh.h"

namespace playhouse::arena {
namespace {

struct Material {
  std::string_view name;
  Surface surface;
};

// Coefficients towards concrete, which has 1. Source: ranges of sliding friction in Oberg, "Machinery's
// Handbook"; of ice on steel, 0.03 to 0.05.
constexpr std::array kMaterials = {
    Material{"concrete", {1, 0.1}}, Material{"asphalt", {1, 0.1}}, Material{"carpet", {1, 0}},
    Material{"rubber", {1, 0.6}},   Material{"wood", {0.6, 0.3}},  Material{"plastic", {0.5, 0.4}},
    Material{"steel", {0.4, 0.3}},  Material{"glass", {0.4, 0.3}}, Material{"ice", {0.05, 0}},
};
constexpr Surface kUnknown{0.6, 0};

const Material* find(std::string_view name) {
  for (const Material& material : kMaterials)
    if (material.name == name) return &material;
  return nullptr;
}

}  // namespace

Surface surface_of(const scene::ModelDesc& desc) {
  const Material* material = find(desc.material);
  Surface surface = material ? material->surface : kUnknown;
  if (desc.material.empty() && desc.mesh && desc.mesh->physics) {
    surface.friction = desc.mesh->physics->friction.value_or(surface.friction);
    surface.restitution = desc.mesh->physics->restitution.value_or(surface.restitution);
  }
  if (desc.friction > 0) surface.friction = desc.friction;
  surface.share_x = desc.friction_x;
  surface.share_y = desc.friction_y;
  return surface;
}

Result<Surface> ground_of(const scene::SceneDesc& scene) {
  if (const Material* material = find(scene.ground)) return material->surface;
  std::vector<std::string_view> names;
  for (const Material& material : kMaterials) names.push_back(material.name);
  return Error{scene.path, "ground " + in_quotes(scene.ground) + " is no material that the arena knows" +
                               did_you_mean(scene.ground, names)};
}

}  // namespace playhouse::arena
