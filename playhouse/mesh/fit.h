#pragma once

#include "playhouse/mesh/mesh.h"
#include "playhouse/mesh/placement.h"

namespace playhouse::mesh {

/// The mesh scaled to the box `size`, centred on x = y = 0, standing on z = 0. An
/// axis without extent stays flat. Round collision shapes stay round: they use
/// the larger of the two scales across their axis, spheres the largest of three.
Mesh fitted(Mesh mesh, const geom::Vec3& size);

/// The mesh scaled, turned and moved to its placement, not fitted. Quarter turns are exact.
/// The result may reach beyond limits: check_mesh(). Round collision shapes stay round.
Mesh placed(Mesh mesh, const Placement& at);

}  // namespace playhouse::mesh
