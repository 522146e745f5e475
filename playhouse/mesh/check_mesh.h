#pragma once

#include "playhouse/base/result.h"
#include "playhouse/mesh/mesh.h"

namespace playhouse::mesh {

/// Validates a mesh: indices in range, finite numbers, at least one
/// triangle, within limits.h. Errors do not include a file name.
Result<void> check_mesh(const Mesh& mesh);

/// Computes the bounding box of all surfaces into low and high.
void measure(Mesh& mesh);

}  // namespace playhouse::mesh
