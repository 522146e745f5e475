#include "playhouse/mesh/import/import_surfaces.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

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

/// Cross product of two edges of a triangle: twice its area, along its normal.
Vec3 area_of(const Surface& surface, const std::array<std::uint32_t, 3>& corner) {
  const auto at = [&](std::size_t k) {
    const auto& p = surface.p[corner[k]];
    return Vec3{p[0], p[1], p[2]};
  };
  return cross(at(1) - at(0), at(2) - at(0));
}

/// Splits vertices with a normal that points inwards, as in files without
/// normals that share vertices: the copy gets the normal of the triangle.
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

/// Joints by name.
using Joints = std::map<std::string_view, Affine>;

Joints joints_of(const Nodes& nodes) {
  Joints joints;
  for (const SceneNode& node : nodes)
    joints.try_emplace({node.node->mName.data, node.node->mName.length}, node.X_FN);
  return joints;
}

/// Skinning transform of each vertex; X for vertices without weights.
std::vector<Affine> skin_of(const aiMesh& from, const Joints& joints, const Affine& X) {
  constexpr Affine kNone{{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}, {}};
  std::vector<Affine> skin(from.mNumVertices, kNone);
  std::vector<double> sum(from.mNumVertices, 0);
  for (unsigned b = 0; b < from.mNumBones; ++b) {
    const aiBone& bone = *from.mBones[b];
    const auto joint = joints.find({bone.mName.data, bone.mName.length});
    if (joint == joints.end()) continue;
    const Affine X_FV = joint->second * affine_of(bone.mOffsetMatrix);
    for (unsigned i = 0; i < bone.mNumWeights; ++i) {
      const auto [corner, share] = bone.mWeights[i];
      if (corner >= skin.size() || !(share > 0)) continue;
      for (std::size_t k = 0; k < 3; ++k) skin[corner].axes[k] = skin[corner].axes[k] + share * X_FV.axes[k];
      skin[corner].p = skin[corner].p + share * X_FV.p;
      sum[corner] += share;
    }
  }
  for (std::size_t i = 0; i < skin.size(); ++i) {
    if (!(sum[i] > 0)) skin[i] = X;
    const double share = sum[i] > 0 ? 1 / sum[i] : 1;
    for (Vec3& axis : skin[i].axes) axis = share * axis;
    skin[i].p = share * skin[i].p;
  }
  return skin;
}

/// Appends the triangles of `from`, transformed by X, or by its skin per vertex.
Result<void> add(const aiMesh& from, const Affine& X, const std::vector<Affine>& skin, Surface& surface) {
  const auto first = static_cast<std::uint32_t>(surface.p.size());
  const auto X_of = [&](unsigned i) -> const Affine& { return skin.empty() ? X : skin[i]; };
  for (unsigned i = 0; i < from.mNumVertices; ++i) {
    surface.p.push_back(floats(X_of(i) * vec(from.mVertices[i])));
    const Vec3 normal = from.HasNormals() ? vec(from.mNormals[i]) : Vec3{0, 0, 1};
    surface.normal.push_back(floats(unit(for_normals(X_of(i)).turn(normal), {0, 0, 1})));
    // Assimp's v axis is up.
    if (from.HasTextureCoords(0)) {
      surface.uv.push_back({from.mTextureCoords[0][i].x, 1 - from.mTextureCoords[0][i].y});
    } else {
      surface.uv.push_back({0, 0});
    }
  }
  for (unsigned i = 0; i < from.mNumFaces; ++i) {
    const aiFace& face = from.mFaces[i];
    if (face.mNumIndices != 3) continue;
    for (unsigned k = 0; k < 3; ++k)
      if (face.mIndices[k] >= from.mNumVertices)
        return Error{{}, "is broken: a triangle has a corner that is not there"};
    std::array<std::uint32_t, 3> corner{first + face.mIndices[0], first + face.mIndices[1],
                                        first + face.mIndices[2]};
    if (X_of(face.mIndices[0]).volume() < 0) std::swap(corner[1], corner[2]);
    const Vec3 area = area_of(surface, corner);
    if (dot(area, area) == 0) continue;  // NaN stays, and is reported by check_mesh()
    mend_normals(surface, corner, area);
    surface.corners.push_back(corner);
  }
  return {};
}

}  // namespace

Result<Nodes> nodes_of(const aiScene& scene, const Affine& X_FS) {
  struct Open {
    const aiNode* node;
    Affine X_FP;
    int depth;
  };
  Nodes nodes;
  std::vector<Open> open{{scene.mRootNode, X_FS, 1}};
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

Result<void> add_surfaces(const aiScene& scene, const Nodes& nodes, Skins skins, Mesh& mesh) {
  const Joints joints = joints_of(nodes);
  std::map<unsigned, Surface> by_material;
  std::size_t corners = 0, triangles = 0;
  for (const SceneNode& node : nodes)
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
      const bool has_skin = skins == Skins::kJoints && part.HasBones();
      const std::vector<Affine> skin = has_skin ? skin_of(part, joints, node.X_FN) : std::vector<Affine>();
      if (const Result<void> added = add(part, node.X_FN, skin, surface); !added) return added;
    }
  for (auto& [material, surface] : by_material)
    if (!surface.corners.empty()) mesh.surfaces.push_back(std::move(surface));
  return {};
}

}  // namespace playhouse::mesh
