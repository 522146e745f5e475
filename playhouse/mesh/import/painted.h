#pragma once

/// Materials of looks (`look` of world files) that take the colour of their model.

#include "playhouse/mesh/mesh.h"

namespace playhouse::mesh {

/// White, without texture.
inline bool is_painted(const Material& material) {
  constexpr float kWhite = 0.999f;
  return material.texture == Material::kNone && material.base[0] >= kWhite && material.base[1] >= kWhite &&
         material.base[2] >= kWhite;
}

}  // namespace playhouse::mesh
