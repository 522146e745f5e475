#pragma once

/// March: traverses the wall grid with many rays in step (DDA), which hides memory
/// latency and vectorises the arithmetic. Cells along a ray are found in single
/// precision: over kFarthestMarch cells the error stays below Walls::kBorder, within
/// which edges are also listed in neighbouring cells, so none is missed. Hits are exact.
///
/// In: walls; rays, those of each part near to each other.
/// Out: range and solid of the rays.
/// Cost: for eight rays at once a step for each cell or empty square along them; when half of the rays
///   have ended, the active ones are compacted.

#include "playhouse/bodies/walls.h"
#include "playhouse/rays/rays.h"

namespace playhouse::rays {

/// Longer rays are traced one by one.  [cells]
inline constexpr double kFarthestMarch = 8192;

/// Shortens the rays of the parts to their nearest wall hits, among walls that are visible to any of `by`.
void march(const bodies::Walls& walls, bodies::SeenByBits by, Rays& rays);

}  // namespace playhouse::rays
