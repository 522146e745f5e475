#pragma once

/// What clients have drawn (world/drawing.h), as shapes for pictures from above.

#include <vector>

#include "playhouse/app/pictures/shape.h"
#include "playhouse/world/world.h"

namespace playhouse::app {

/// Appends triangles, lines of that width and points as squares of three times the width [m], of each model in the
/// order in which the page has them: those of layer 2d by form, then others.
void add_client_drawings(std::vector<FilledShape>& shapes, const world::World& world, double line_width);

}  // namespace playhouse::app
