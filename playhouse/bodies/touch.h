#pragma once

/// Contact queries between bodies, whether or not they are obstacles.
///
/// In: solids at their present places, and a model.
/// Out: rows of models.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/bodies/space.h"

namespace playhouse::bodies {

/// Appends the models of other trees whose bodies touch or overlap that of `model`, whatever their
/// heights, and that are `wanted` (by row of the models): ascending, without duplicates. A model's
/// body excludes attached models. Cost: linear in nearby movable bodies and in all static ones.
void touching(const Space& space, const Trees& trees, const world::Models& models, world::ModelRow model,
              const world::ByModel<std::uint8_t>& wanted, std::vector<world::ModelRow>& out);

}  // namespace playhouse::bodies
