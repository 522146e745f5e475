#include "playhouse/scene/forms/materials.h"

#include <array>

namespace playhouse::scene {
namespace {

constexpr double kAsColor = -1;

// Friction and restitution: ranges of sliding friction in Oberg, "Machinery's Handbook"; of ice
// on steel, 0.03 to 0.05. Reflectance at 0.9 um from RIEGL ("Reflectance of materials"): white
// paper up to 100 %, smooth concrete 24 %, asphalt with pebbles 17 %, a clean rough pallet 25 %,
// black neoprene 5 %, a tyre's wall 2 %. Grey PVC 50 %: SICK, technical description of the LMS
// 200. Glass of index 1.52 reflects 4.3 % per face (Fresnel), plus some dust; silvered glass
// about 90 %; that brushed steel scatters half of the 60 % that it returns is our assumption.
constexpr std::array kMaterials = {
    NamedMaterial{"concrete", 1, 0.1, 0, 0.95f, 0.24, 0, 0},
    NamedMaterial{"asphalt", 1, 0.1, 0, 0.95f, 0.17, 0, 0},
    NamedMaterial{"carpet", 1, 0, 0, 1, kAsColor, 0, 0},
    NamedMaterial{"rubber", 1, 0.6, 0, 0.85f, 0.02, 0, 0},
    NamedMaterial{"wood", 0.6, 0.3, 0, 0.7f, 0.25, 0, 0},
    NamedMaterial{"plastic", 0.5, 0.4, 0, 0.4f, 0.5, 0, 0},
    NamedMaterial{"steel", 0.4, 0.3, 0.85f, 0.35f, 0.3, 0.3, 0},
    NamedMaterial{"glass", 0.4, 0.3, 0, 0.05f, 0.002, 0.043, 1},
    NamedMaterial{"mirror", 0.4, 0.3, 0.9f, 0.05f, 0.002, 0.9, 0},
    NamedMaterial{"ice", 0.05, 0, 0, 0.12f, kAsColor, 0, 0},
    NamedMaterial{"paper", 0.6, 0, 0, 0.6f, 0.9, 0, 0},
    NamedMaterial{"neoprene", 0.6, 0, 0, 0.6f, 0.05, 0, 0},
};
constexpr NamedMaterial kUnknown{"", 0.6, 0, 0, 0.6f, kAsColor, 0, 0};

}  // namespace

const NamedMaterial& material_named(std::string_view name) {
  for (const NamedMaterial& material : kMaterials)
    if (material.name == name) return material;
  return kUnknown;
}

NamedMaterial material_of(const ModelDesc& model) {
  NamedMaterial material = material_named(model.material);
  material.restitution = model.restitution.value_or(material.restitution);
  material.roughness = static_cast<float>(model.roughness.value_or(material.roughness));
  return material;
}

bool is_material(std::string_view name) {
  return !name.empty() && material_named(name).name == name;
}

std::vector<std::string_view> material_names() {
  std::vector<std::string_view> names;
  for (const NamedMaterial& material : kMaterials) names.push_back(material.name);
  return names;
}

bool is_smoke(const ModelDesc& model) {
  return model.material == kSmoke;
}

}  // namespace playhouse::scene
