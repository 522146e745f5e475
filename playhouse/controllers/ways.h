#pragma once

/// Ways: the floor as a table of cells that tells, from each, where the shortest way to a place goes on that
/// keeps off what stands still. What moves is not in it. A value type.

#include <cstdint>
#include <optional>
#include <vector>

#include "playhouse/world/world.h"

namespace playhouse::controllers {

class Ways {
 public:
  /// To anywhere within `reach` of the place, for a robot that meets what is below `height` and whose centre
  /// keeps `clearance` off it. Where others come along `oncoming_W`, a way beside theirs is taken if it is
  /// not far longer. [m, W]
  Ways(const world::World& world, geom::Vec2 place_W, double reach, double clearance, double height,
       const std::vector<geom::Vec2>& oncoming_W = {});

  /// Where to head for from here: less than a metre away, or the place itself where that is within reach;
  /// none where no way leads there. [m, W]
  std::optional<geom::Vec2> next(geom::Vec2 p_W) const;

  /// The way from here, cell by cell; empty where there is none. [m, W]
  std::vector<geom::Vec2> route(geom::Vec2 p_W) const;

 private:
  struct Cell {
    std::int64_t x = 0, y = 0;
  };
  Cell cell_at(geom::Vec2 p_W) const;
  bool is_floor(Cell cell) const { return cell.x >= 0 && cell.x < columns_ && cell.y >= 0 && cell.y < rows_; }
  std::uint32_t number(Cell cell) const { return static_cast<std::uint32_t>(cell.y * columns_ + cell.x); }
  geom::Vec2 centre(Cell cell) const;
  void mark(geom::Vec2 from_W, geom::Vec2 to_W, double around, std::uint8_t cost);
  void search(double reach);
  std::optional<Cell> nearest_with_way(Cell from) const;

  geom::Vec2 place_W_, corner_W_;  // m; the second is the lower left corner of the floor
  double side_ = 1;                // m, of a cell
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<std::uint8_t> cost_;   // of a step into the cell; 0: blocked
  std::vector<std::uint32_t> next_;  // number of the next cell; its own within reach
};

}  // namespace playhouse::controllers
