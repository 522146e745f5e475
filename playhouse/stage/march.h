#pragma once

/// March: many rays through the cells of the walls, all a step at a time, so that no ray waits for another's
/// memory and the arithmetic is done in vectors. Which cells a ray crosses is worked out in single precision:
/// over kFarthestMarch cells that errs by less than the border by which edges are listed in neighbouring
/// cells, so that none is missed. Where an edge is met is exact.

#include "playhouse/stage/rays.h"
#include "playhouse/stage/walls.h"

namespace playhouse::stage {

/// Rays that reach further go one by one.  [cells]
inline constexpr double kFarthestMarch = 8192;

/// Shortens the rays to the walls that they meet, of those that these observers see.
void march(const Walls& walls, Observers by, Rays& rays);

}  // namespace playhouse::stage
