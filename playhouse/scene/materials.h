#pragma once

/// What things are made of: the one table of materials, by the word `material` of a model. Whoever needs to
/// know how a surface rubs, shines or scatters reads it here; docs/arena.md lists the same rows.

#include <span>
#include <string_view>

#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

struct Material {
  std::string_view name;
  double friction;            // towards concrete, which has 1
  double restitution;         // 0 to 1
  float metallic, roughness;  // 0 to 1, of the metallic-roughness model of glTF 2.0
  double scatters;            // share of light of 0.9 um; below 0: as its color says
  double mirrors, passes;     // shares of that light, square on
};

/// Of what is made of nothing that is known: its name is empty.
const Material& material_named(std::string_view name);

std::span<const Material> materials();

/// A cloud: seen, but no body to rays.
bool is_smoke(const ModelDesc& model);

}  // namespace playhouse::scene
