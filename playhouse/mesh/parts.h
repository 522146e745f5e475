#pragma once

#include <cstddef>
#include <vector>

#include "playhouse/mesh/mesh.h"

namespace playhouse::mesh {

/// Connected components: the points of each part of a mesh, where triangles that share a point,
/// in any surface, are one part. If there are more than `most`, one part per surface; if still
/// more, a single part. In surface order; equal points merged. Cost: a sort of points.
std::vector<std::vector<geom::Vec3>> parts_of(const Mesh& mesh, std::size_t most);

}  // namespace playhouse::mesh
