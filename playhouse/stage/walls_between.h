#pragma once

/// How many walls are on a straight line: outlines of what stands still that it enters.

#include <cstdint>
#include <vector>

#include "playhouse/stage/space.h"

namespace playhouse::stage {

/// From one place to the other, at the height of the first; bodies that `by` does not see are none. `crossed`
/// is scratch memory.
int walls_between(const Space& space, const Pose& from_W, const Pose& to_W, Observers by,
                  std::vector<std::uint32_t>& crossed);

}  // namespace playhouse::stage
