#include "playhouse/drivers/maps/mapcspace.h"

#include <string>
#include <vector>

#include "playhouse/drivers/grid_map/distances.h"
#include "playhouse/drivers/maps/map_filter.h"

namespace playhouse::drivers {

namespace {

/// Which cells are within a radius of one with this value: 1. `most`: the square of the radius, in cells.
std::vector<std::uint8_t> cells_near(const GridMap& map, std::int8_t value, double most) {
  std::vector<std::uint8_t> grown(map.cells.size());
  for (std::size_t i = 0; i < grown.size(); ++i) grown[i] = map.cells[i] == value;
  const std::vector<std::uint32_t> distances = squared_distances(map.width(), map.height(), grown);
  for (std::size_t i = 0; i < grown.size(); ++i) grown[i] = distances[i] < kFarAway && distances[i] <= most;
  return grown;
}

}  // namespace

Result<GridMap> MapCSpace::map(const GridMap& source) const {
  constexpr double kRounding = 1e-6;  // as the size of a cell is a float32
  const double cells = radius / static_cast<double>(source.info.scale);
  const double most = cells * cells * (1 + kRounding);
  const std::vector<std::uint8_t> occupied = cells_near(source, 1, most),
                                  unknown = cells_near(source, 0, most);
  GridMap grown = source;
  for (std::size_t i = 0; i < grown.cells.size(); ++i)
    grown.cells[i] = occupied[i] != 0 ? std::int8_t{1} : unknown[i] != 0 ? std::int8_t{0} : std::int8_t{-1};
  return grown;
}

Result<MapCSpace> map_cspace_options(SectionFields fields) {
  const double radius =
      fields.length({"robot_radius", "By which obstacles and unknown cells grow.", {}, "required"}, -1,
                    SectionFields::kAnyNumber);
  fields.expect(radius >= 0, "robot_radius", "is needed, 0 m at least");
  const std::string shape = fields.text({"robot_shape", "circle, which is also what it is without."});
  fields.expect(shape.empty() || shape == "circle", "robot_shape", "is \"circle\"");
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return MapCSpace{radius};
}

constinit const DriverDefinition kMapCSpaceDriver{
    .name = "mapcspace",
    .doc = "A map whose obstacles are larger by the radius of a robot.",
    .provides = kMapFilterProvides,
    .uses = kMapFilterUses,
    .read_options = reading<map_cspace_options>,
    .make = make_map_filter<map_cspace_options, MapCSpace>,
};

}  // namespace playhouse::drivers
