#pragma once

#include <cstddef>
#include <vector>

#include "playhouse/mesh/mesh.h"

namespace playhouse::mesh {

/// The corners of each part of a mesh: triangles that share corners are one, in whatever surface. Where there
/// are more than `most` parts, a surface is one, and where there are more of them, all is. In the order of
/// surfaces; equal corners are one. Cost: sorts the corners.
std::vector<std::vector<geom::Vec3>> parts_of(const Mesh& mesh, std::size_t most);

}  // namespace playhouse::mesh
