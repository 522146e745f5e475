#pragma once

/// Who touches whom, whether or not they are obstacles.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/stage/space.h"

namespace playhouse::stage {

/// Appends the models of other trees whose bodies touch or overlap that of `model`, whatever their heights,
/// and that are `wanted` (by row of the models): ascending, each once. The body of a model is its own,
/// without what is attached to it. Cost: the bodies near it, and those that stand still.
void touching(const Space& space, const Trees& trees, const world::Models& models, world::ModelRow model,
              std::span<const std::uint8_t> wanted, std::vector<std::uint32_t>& out);

}  // namespace playhouse::stage
