#pragma once

/// A grid map.

#include <cstdint>
#include <optional>
#include <vector>

#include "playhouse/wire/generated/map.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"

namespace playhouse::client {

/// A cell of a map: its column from the left and its row from the bottom, from 0.
struct Cell {
  std::uint32_t column = 0, row = 0;
  friend bool operator==(const Cell&, const Cell&) = default;
};

/// The grid of a map: its size and place.
struct Grid {
  double cell_size = 1;                 // length of a cell's side [m]
  std::uint32_t width = 0, height = 0;  // cells
  Pose origin;                          // of the lower left corner of cell (0, 0), in the world

  /// The cell with this point of the world; none beyond the map.
  std::optional<Cell> cell_of(const Point& point) const;
};

class Map {
 public:
  /// Rows of cells from the bottom: rows[row][column].
  using Rows = std::vector<std::vector<std::int8_t>>;

  static Result<Map> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// Requests size and place of the map, without its cells. An error also if the numbers are those of no map.
  Result<Grid> grid();

  /// Requests the whole map. A cell is 1 if it is occupied, -1 if it is free, 0 if that is unknown. An error
  /// also for a map of more than 2^26 cells, and for faulty answers.
  Result<Rows> cells();

  Device& device() { return device_; }

 private:
  friend class RobotDevices;
  explicit Map(Device device) : device_(std::move(device)) {}
  /// All cells of the rows from `row` on, as high as a tile.
  Result<Rows> band(std::uint32_t row, std::uint32_t width, std::uint32_t height);
  Result<std::vector<std::int8_t>> tile(const wire::map::Data& asked);

  Device device_;
};

}  // namespace playhouse::client
