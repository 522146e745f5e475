#pragma once

/// Rows of the tables of bodies (bodies.h). Values.

#include "playhouse/base/row.h"

namespace playhouse::bodies {

using TreeRow = Row<struct Trees>;
using MoverRow = Row<struct Mover>;  // of Trees::movers
using SolidRow = Row<struct Solids>;
using SolidRows = RowsOf<struct Solids>;
using VertexRow = Row<struct Vertices>;  // of Solids::p
using VertexRows = RowsOf<struct Vertices>;
using CornersRow = Row<struct EightCorners>;  // of Solids::corners
using EdgeRow = Row<struct WallEdges>;        // edges of static solids, in the order of their vertices

}  // namespace playhouse::bodies
