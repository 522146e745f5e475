#pragma once

#include "playhouse/mesh/mesh.h"

namespace playhouse::mesh {

/// The mesh stretched so that its box is as large as `size`, centred about x = y = 0 and standing on z = 0.
/// What has no extent along an axis has none then either. Spheres, capsules and cylinders for physics stay
/// what they are: the larger stretch of two across their axis counts, and of three for spheres.
Mesh fitted(Mesh mesh, const geom::Vec3& size);

}  // namespace playhouse::mesh
