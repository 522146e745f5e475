#pragma once

/// The .cfg driver "mapcspace": a map on which a round robot is a point.
///
/// In: a grid, and the robot's radius.
///
/// Out: a cell is occupied if its middle is no farther than the radius from that of an occupied cell, else unknown if so far
/// from that of an unknown one.
///
/// Cost: linear in the number of cells, 25 ns each (grid_map/distances.h).

#include "playhouse/base/result.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/grid_map/grid_map.h"
#include "playhouse/drivers/section_fields.h"

namespace playhouse::drivers {

struct MapCSpace {
  double radius = 0;  // m

  Result<GridMap> map(const GridMap& source) const;
};

Result<MapCSpace> map_cspace_options(SectionFields fields);

extern const DriverDefinition kMapCSpaceDriver;

}  // namespace playhouse::drivers
