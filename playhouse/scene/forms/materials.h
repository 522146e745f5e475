#pragma once

/// Materials: the one table, keyed by the word `material` of a model. Friction,
/// shininess and optics all come from here; docs/arena.md lists the same rows.

#include <span>
#include <string_view>
#include <vector>

#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

struct NamedMaterial {
  std::string_view name;
  double friction;            // against concrete, which has 1
  double restitution;         // 0 to 1
  float metallic, roughness;  // 0 to 1, of the metallic-roughness model of glTF 2.0
  double scatters;            // diffuse reflectance at 0.9 um; below 0: by its color
  double mirrors, passes;     // specular reflectance, transmittance at normal incidence
};

/// The default for unknown materials has an empty name.
const NamedMaterial& material_named(std::string_view name);

/// That of a model, with its words `restitution` and `roughness`.
NamedMaterial material_of(const ModelDesc& model);

bool is_material(std::string_view name);
std::vector<std::string_view> material_names();

/// A smoke cloud: visible, but transparent to rays.
inline constexpr std::string_view kSmoke = "smoke";
bool is_smoke(const ModelDesc& model);

}  // namespace playhouse::scene
