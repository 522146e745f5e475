#pragma once

/// The .cfg driver "mapscale": a map with cells of another size.
///
/// In: a grid, and the size of a cell.
///
/// Out: a cell is occupied if a part of it is, else unknown if a part of it is, else free. The map has the place and at
/// least the size of the other one; what is beyond that is unknown.

#include "playhouse/base/result.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/grid_map/grid_map.h"
#include "playhouse/drivers/section_fields.h"

namespace playhouse::drivers {

struct MapScale {
  double resolution = 0;  // m, of a cell

  /// Fails if it had too many cells.
  Result<GridMap> map(const GridMap& source) const;
};

Result<MapScale> map_scale_options(SectionFields fields);

extern const DriverDefinition kMapScaleDriver;

}  // namespace playhouse::drivers
