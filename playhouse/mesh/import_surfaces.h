#pragma once

/// Triangles of an Assimp scene, with its nodes applied.

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

struct Node {
  const aiNode* node = nullptr;
  Affine X_FN;
};
using Nodes = std::vector<Node>;

/// All nodes, parents first. Fails on more, and on deeper ones, than limits.h allows.
Result<Nodes> nodes_of(const aiScene& scene);

/// What a mesh with a skin goes by: glTF has it where its joints at rest have it, whatever its node.
enum class Skins : std::uint8_t { kNodes, kJoints };

/// A surface for each material that triangles have.
Result<void> add_surfaces(const aiScene& scene, const Nodes& nodes, Skins skins, Mesh& mesh);

}  // namespace playhouse::mesh
