#pragma once

/// What is seen of and through surfaces, by the opacity of their material and of its texture.

#include <cstddef>

#include "playhouse/mesh/mesh.h"

namespace playhouse::mesh {

/// Whether a pixel is not fully opaque.
inline bool has_clear_pixels(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    if (image.rgba[i] != 255) return true;
  return false;
}

/// Whether a pixel of the material's texture is not fully opaque.
inline bool has_clear_texture(const Mesh& mesh, const Material& material) {
  return material.texture < mesh.images.size() && has_clear_pixels(mesh.images[material.texture]);
}

/// Whether one sees what is behind such a surface through it, more or less.
inline bool is_see_through(const Mesh& mesh, const Material& material) {
  return material.opacity == Opacity::kClear && (material.base[3] < 1 || has_clear_texture(mesh, material));
}

/// Whether nothing of such a surface is there.
inline bool is_all_hole(const Material& material) {
  return material.opacity == Opacity::kHoles && material.base[3] < material.least_opacity;
}

}  // namespace playhouse::mesh
