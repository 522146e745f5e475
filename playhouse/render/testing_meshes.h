#pragma once

/// Meshes for tests and benches.

#include "playhouse/mesh/mesh.h"

namespace playhouse::render::testing {

/// A box of one material about the origin.
inline mesh::Mesh box(const geom::Vec3& half) {
  mesh::Mesh mesh;
  mesh.materials.emplace_back();
  mesh::Surface& surface = mesh.surfaces.emplace_back();
  for (int axis = 0; axis < 3; ++axis)
    for (const float way : {-1.0f, 1.0f}) {
      const auto first = static_cast<std::uint32_t>(surface.p.size());
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (const auto& [a, b] : {std::pair(-1.0f, -way), {1.0f, -way}, {1.0f, way}, {-1.0f, way}}) {
        std::array<float, 3> p{}, n{};
        const float half_of[3] = {static_cast<float>(half.x), static_cast<float>(half.y),
                                  static_cast<float>(half.z)};
        p[axis] = way * half_of[axis];
        p[u] = a * half_of[u];
        p[v] = b * half_of[v];
        n[axis] = way;
        surface.p.push_back(p);
        surface.normal.push_back(n);
        surface.uv.push_back({0.5f + 0.5f * a, 0.5f + 0.5f * b});
      }
      surface.corners.push_back({first, first + 1, first + 2});
      surface.corners.push_back({first, first + 2, first + 3});
    }
  return mesh;
}

}  // namespace playhouse::render::testing
