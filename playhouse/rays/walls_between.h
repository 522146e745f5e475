#pragma once

/// Counts walls along a line segment: outlines of static bodies that it enters.
///
/// In: the walls, and two places.
/// Out: how many outlines are entered between them.
/// Cost: the edges in cells along the segment; a sort of those that are crossed.

#include <cstddef>
#include <vector>

#include "playhouse/bodies/space.h"

namespace playhouse::rays {

inline constexpr std::size_t kUsualCrossings = 64;  // edges between two places: reserved capacity of buffers

/// From one place to the other, at the height of the first; ignores bodies that `by` does
/// not see, and those of the trees of `own` and `target`. `crossed` is a scratch buffer.
int walls_between(const bodies::Space& space, const geom::Pose& from_W, const geom::Pose& to_W,
                  bodies::SeenByBits by, std::vector<bodies::EdgeRow>& crossed, world::ModelRow own = {},
                  world::ModelRow target = {});

}  // namespace playhouse::rays
