#pragma once

/// Ways: navigation function on a grid: from each cell the next step of the shortest
/// path to a goal around static obstacles. Movable bodies are ignored. A value type.

#include <cstdint>
#include <optional>
#include <vector>

#include "playhouse/world/world.h"

namespace playhouse::controllers {

class Ways {
 public:
  /// Paths to anywhere within `reach` of the goal, for a robot that collides with obstacles
  /// below `height` and keeps its centre `clearance` away from them. Where others come
  /// along `oncoming_W`, a parallel lane is preferred if the detour is small. [m, W]
  Ways(const world::World& world, geom::Vec2 place_W, double reach, double clearance, double height,
       const std::vector<geom::Vec2>& oncoming_W = {});

  /// The next waypoint from here: less than a metre away, or the
  /// goal itself if within reach; none if it is unreachable. [m, W]
  std::optional<geom::Vec2> next(geom::Vec2 p_W) const;

  /// The path from here, by cells; empty if the goal is unreachable. [m, W]
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

  geom::Vec2 place_W_, corner_W_;  // m; goal, and lower left corner of the grid
  double side_ = 1;                // m, of a cell
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<std::uint8_t> cost_;   // of entering the cell; 0: blocked
  std::vector<std::uint32_t> next_;  // index of the next cell; its own if within reach
};

}  // namespace playhouse::controllers
