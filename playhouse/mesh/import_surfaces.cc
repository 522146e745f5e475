#include "playhouse/mesh/import_surfaces.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>

#include "playhouse/base/mesh_limits.h"

namespace playhouse::mesh {
namespace {

using geom::Vec3;

Affine affine_of(const aiMatrix4x4& m) {
  return {{{{m.a1, m.b1, m.c1}, {m.a2, m.b2, m.c2}, {m.a3, m.b3, m.c3}}}, {m.a4, m.b4, m.c4}};
}

Vec3 vec(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}
std::array<float, 3> floats(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// Twice the area of a triangle, along its normal.
Vec3 area_of(const Surface& surface, const std::array<std::uint32_t, 3>& corner) {
  const auto at = [&](std::size_t k) {
    const auto& p = surface.p[corner[k]];
    return Vec3{p[0], p[1], p[2]};
  };
  return cross(at(1) - at(0), at(2) - at(0));
}

/// Corners whose normals do not look out of the triangle, as of files that say none and share corners, become
/// corners of their own with the normal of the triangle.
void mend_normals(Surface& surface, std::array<std::uint32_t, 3>& corner, const Vec3& area) {
  constexpr double kLeast = 1e-3;  // cosine between a normal and that of its triangle
  const Vec3 normal = unit(area, {0, 0, 1});
  for (std::uint32_t& row : corner) {
    const auto& n = surface.normal[row];
    if (dot(normal, {n[0], n[1], n[2]}) >= kLeast) continue;
    const auto p = surface.p[row];
    const auto uv = surface.uv[row];
    row = static_cast<std::uint32_t>(surface.p.size());
    surface.p.push_back(p);
    surface.normal.push_back(floats(normal));
    surface.uv.push_back(uv);
  }
}

/// Appends the triangles of `from` where X has them.
Result<void> add(const aiMesh& from, const Affine& X, Surface& surface) {
  const auto first = static_cast<std::uint32_t>(surface.p.size());
  const Affine X_normal = for_normals(X);
  for (unsigned i = 0; i < from.mNumVertices; ++i) {
    surface.p.push_back(floats(X * vec(from.mVertices[i])));
    const Vec3 normal = from.HasNormals() ? vec(from.mNormals[i]) : Vec3{0, 0, 1};
    surface.normal.push_back(floats(unit(X_normal.turn(normal), {0, 0, 1})));
    // Assimp's v is up.
    if (from.HasTextureCoords(0)) {
      surface.uv.push_back({from.mTextureCoords[0][i].x, 1 - from.mTextureCoords[0][i].y});
    } else {
      surface.uv.push_back({0, 0});
    }
  }
  const bool mirrors = X.volume() < 0;
  for (unsigned i = 0; i < from.mNumFaces; ++i) {
    const aiFace& face = from.mFaces[i];
    if (face.mNumIndices != 3) continue;
    for (unsigned k = 0; k < 3; ++k)
      if (face.mIndices[k] >= from.mNumVertices)
        return Error{{}, "is broken: a triangle has a corner that is not there"};
    std::array<std::uint32_t, 3> corner{first + face.mIndices[0], first + face.mIndices[1],
                                        first + face.mIndices[2]};
    if (mirrors) std::swap(corner[1], corner[2]);
    const Vec3 area = area_of(surface, corner);
    if (dot(area, area) == 0) continue;  // what is no number stays, and is told later
    mend_normals(surface, corner, area);
    surface.corners.push_back(corner);
  }
  return {};
}

}  // namespace

Result<Nodes> nodes_of(const aiScene& scene) {
  struct Open {
    const aiNode* node;
    Affine X_FP;
    int depth;
  };
  Nodes nodes;
  std::vector<Open> open{{scene.mRootNode, from_y_up(), 1}};
  while (!open.empty()) {
    const Open next = open.back();
    open.pop_back();
    if (next.depth > limits::kMeshDepth)
      return Error{{}, fmt::format("has nodes more than {} deep", limits::kMeshDepth)};
    if (nodes.size() >= limits::kMeshNodes)
      return Error{{}, fmt::format("has too many nodes: up to {} are possible", limits::kMeshNodes)};
    const Affine X_FN = next.X_FP * affine_of(next.node->mTransformation);
    nodes.push_back({next.node, X_FN});
    for (unsigned i = next.node->mNumChildren; i-- > 0;)
      open.push_back({next.node->mChildren[i], X_FN, next.depth + 1});
  }
  return nodes;
}

Result<void> add_surfaces(const aiScene& scene, const Nodes& nodes, Mesh& mesh) {
  std::map<unsigned, Surface> by_material;
  std::size_t corners = 0, triangles = 0;
  for (const Node& node : nodes)
    for (unsigned i = 0; i < node.node->mNumMeshes; ++i) {
      if (node.node->mMeshes[i] >= scene.mNumMeshes)
        return Error{{}, "is broken: a node has a mesh that is not there"};
      const aiMesh& part = *scene.mMeshes[node.node->mMeshes[i]];
      corners += part.mNumVertices;
      triangles += part.mNumFaces;
      if (corners > limits::kMeshCorners || triangles > limits::kMeshTriangles)
        return Error{{},
                     fmt::format("has too many triangles: up to {}, with {} corners, are possible",
                                 limits::kMeshTriangles, limits::kMeshCorners)};
      Surface& surface = by_material[part.mMaterialIndex];
      surface.material = part.mMaterialIndex;
      if (const Result<void> added = add(part, node.X_FN, surface); !added) return added;
    }
  for (auto& [material, surface] : by_material)
    if (!surface.corners.empty()) mesh.surfaces.push_back(std::move(surface));
  return {};
}

}  // namespace playhouse::mesh
