#pragma once

/// March: many rays from about one place through the cells of the walls, all a step at a time, so that no ray
/// waits for another's memory and the arithmetic is done in vectors. Visits what Walls::along would.

#include "playhouse/stage/rays.h"
#include "playhouse/stage/walls.h"

namespace playhouse::stage {

inline constexpr double kFarthestMarch = 30000;  // cells; rays that reach further go one by one

/// Shortens the rays to the walls that they meet.
void march(const Walls& walls, Rays& rays);

}  // namespace playhouse::stage
