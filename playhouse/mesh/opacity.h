#pragma once

/// Transparency of surfaces, from material and texture.

#include <cstddef>

#include "playhouse/mesh/mesh.h"

namespace playhouse::mesh {

/// True if any pixel is not opaque.
inline bool has_clear_pixels(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    if (image.rgba[i] != 255) return true;
  return false;
}

/// True if the material's texture has a pixel that is not opaque.
inline bool has_clear_texture(const Mesh& mesh, const Material& material) {
  return material.texture < mesh.images.size() && has_clear_pixels(mesh.images[material.texture]);
}

/// True if the surface needs blending.
inline bool is_see_through(const Mesh& mesh, const Material& material) {
  return material.opacity == Opacity::kClear && (material.base[3] < 1 || has_clear_texture(mesh, material));
}

/// True if the alpha test discards the whole surface.
inline bool is_all_hole(const Material& material) {
  return material.opacity == Opacity::kHoles && material.base[3] < material.least_opacity;
}

}  // namespace playhouse::mesh
