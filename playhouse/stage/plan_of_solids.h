#pragma once

#include <cstddef>
#include <functional>

#include "playhouse/base/result.h"
#include "playhouse/scene/plan.h"
#include "playhouse/stage/bodies.h"

namespace playhouse::stage {

/// Rasterises, as seen from above, the solids of which `counts` is true, by their rows. A pixel is
/// dark if its centre is inside one, or if the outline of one crosses it where it is thinner than a pixel.
/// The plan has a margin of one pixel about them and no pixels if none counts; its edges are at multiples of
/// the resolution [m]. Fails beyond the size limit of bitmaps.
Result<scene::Plan> plan_of_solids(const Solids& solids, double resolution,
                                   const std::function<bool(std::size_t row)>& counts);

}  // namespace playhouse::stage
