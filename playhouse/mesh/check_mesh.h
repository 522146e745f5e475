#pragma once

#include "playhouse/base/result.h"
#include "playhouse/mesh/mesh.h"

namespace playhouse::mesh {

/// Whether a mesh is what mesh.h says: rows are rows, numbers are finite, there are triangles and no more of
/// anything than limits.h allows. Fails with a text that names no file.
Result<void> check_mesh(const Mesh& mesh);

/// The box that holds all surfaces, into low and high.
void measure(Mesh& mesh);

}  // namespace playhouse::mesh
