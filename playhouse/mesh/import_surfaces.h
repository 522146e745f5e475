#pragma once

/// Triangles of an Assimp scene, with its nodes applied.

#include <assimp/scene.h>

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

/// A surface for each material that triangles have.
Result<void> add_surfaces(const aiScene& scene, const Nodes& nodes, Mesh& mesh);

}  // namespace playhouse::mesh
