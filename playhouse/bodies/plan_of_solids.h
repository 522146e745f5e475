#pragma once

/// Plans of worlds from above, for maps.
///
/// In: solids in W, and the side of a pixel. [m]
/// Out: a plan from above.
/// Cost: its pixels, and the edges of the solids.

#include <cstddef>
#include <functional>

#include "playhouse/base/result.h"
#include "playhouse/bodies/bodies.h"
#include "playhouse/scene/images/plan.h"

namespace playhouse::bodies {

/// Where maps of worlds are cut, unless a word or an option says otherwise: where robots see and meet. [m]
inline constexpr double kMapHeight = 0.2;

/// True for walls of a map: obstacles that a plane at `height` above the floor of the world cuts. [m]
bool is_wall_at(const Solids& solids, SolidRow row, double height);

/// Rasterises, as seen from above, the solids of which `counts` is true, by their rows. A pixel is
/// dark if its centre is inside one, or if the outline of one crosses it where it is thinner than a pixel.
/// The plan has a margin of one pixel about them and no pixels if none counts; its edges are at multiples of
/// the resolution [m]. Fails beyond the size limit of bitmaps.
Result<scene::Plan> plan_of_solids(const Solids& solids, double resolution,
                                   const std::function<bool(SolidRow row)>& counts);

}  // namespace playhouse::bodies
