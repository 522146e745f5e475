#pragma once

#include "playhouse/mesh/mesh.h"

namespace playhouse::mesh {

/// The mesh scaled to the box `size`, centred on x = y = 0, standing on z = 0. An
/// axis without extent stays flat. Round collision shapes stay round: they use
/// the larger of the two scales across their axis, spheres the largest of three.
Mesh fitted(Mesh mesh, const geom::Vec3& size);

}  // namespace playhouse::mesh
