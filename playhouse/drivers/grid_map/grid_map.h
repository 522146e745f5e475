#pragma once

/// GridMap: an occupancy grid, as interface map has it. Frames: W of the world, G of the
/// grid, whose origin is the outer corner of cell (0, 0) and whose unit is the metre.

#include <cstdint>
#include <optional>
#include <vector>

#include "playhouse/device/driver.h"
#include "playhouse/geom/pose.h"
#include "playhouse/wire/generated/map.h"

namespace playhouse::drivers {

struct GridMap {
  wire::map::Info info;
  std::vector<std::int8_t> cells;  // by rows from the bottom; 1 occupied, -1 free, 0 unknown

  int width() const { return static_cast<int>(info.width); }
  int height() const { return static_cast<int>(info.height); }
  geom::Pose X_WG() const { return {info.origin.px, info.origin.py, 0, info.origin.pa}; }
};

/// The answer to a request for a rectangle of cells, which are compressed. What is
/// beyond the map is unknown. None if the rectangle has more cells than a message.
std::optional<wire::map::Data> map_tile(const GridMap& map, const wire::map::Data& request);

/// The edges between occupied cells and others as lines, in the frame G of the map: those along x first, from the bottom up,
/// then those along y, from the left; straight runs are one line. None if they are more than a message holds.
std::optional<wire::map::DataVector> map_lines(const GridMap& map);

/// True for the requests that answer_map_request() knows: GET_INFO and GET_DATA.
bool is_map_request(std::uint8_t type, std::uint8_t subtype);

/// Any thread. Other requests and invalid ones get NACK.
void answer_map_request(const GridMap& map, const device::Message& message, device::Replier replier);

}  // namespace playhouse::drivers
