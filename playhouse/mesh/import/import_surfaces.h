#pragma once

/// Triangles of an Assimp scene, in F.

#include <assimp/scene.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/mesh/affine.h"
#include "playhouse/mesh/mesh.h"

namespace playhouse::mesh {

struct SceneNode {
  const aiNode* node = nullptr;
  Affine X_FN;
};
using Nodes = std::vector<SceneNode>;

/// All nodes, parents first; X_FS turns the axes of the scene. Fails beyond limits.h on number and depth.
Result<Nodes> nodes_of(const aiScene& scene, const Affine& X_FS);

/// Transform of skinned meshes: by their node, or, in glTF, by their joints at rest.
enum class Skins : std::uint8_t { kNodes, kJoints };

/// Merges triangles into one surface per material.
Result<void> add_surfaces(const aiScene& scene, const Nodes& nodes, Skins skins, Mesh& mesh);

}  // namespace playhouse::mesh
