#pragma once

/// Counts walls along a line segment: outlines of static bodies that it enters.

#include <cstdint>
#include <vector>

#include "playhouse/stage/space.h"

namespace playhouse::stage {

/// From one place to the other, at the height of the first; ignores
/// bodies that `by` does not see. `crossed` is a scratch buffer.
int walls_between(const Space& space, const Pose& from_W, const Pose& to_W, Observers by,
                  std::vector<std::uint32_t>& crossed);

}  // namespace playhouse::stage
