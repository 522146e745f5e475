#pragma once

/// CostMap: a grid map for planning, and steps between its cells.
///
/// In: a map, whose unknown cells, and what is beyond it, count as obstacles.
///
/// Out: for each cell what a path through it costs, and whether one may go there.
///
/// Cost: linear in the cells, 4 ms for 500 x 500 in a release build.
///
/// Source: distances.h for the distances from obstacles.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "playhouse/drivers/grid_map/grid_map.h"
#include "playhouse/geom/pose.h"

namespace playhouse::drivers {

inline constexpr double kMostPenalty = 1000;

struct PlanOptions {
  double safety_distance = 0.25;  // m; no path is closer to an obstacle
  double max_radius = 1;          // m; clearance beyond this is no better
  double penalty = 1;  // at most kMostPenalty; at the safety distance a path costs 1 + this times more
};

/// Index of a cell of a CostMap.
using CellIndex = std::uint32_t;

/// Its cells have a border of obstacles; by rows from the bottom.
struct CostMap {
  // Weights of cells that are no part of a path.
  static constexpr std::uint16_t kObstacle = 0;
  static constexpr std::uint16_t kNear = 1;    // to an obstacle
  static constexpr std::uint16_t kPlain = 64;  // weight of a cell far from obstacles, the least of free ones

  int width = 0, height = 0;  // with the border
  double scale = 0;           // m per cell
  std::vector<std::uint16_t> weights;

  bool free(CellIndex cell) const { return weights[cell] >= kPlain; }

  std::size_t count() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  CellIndex cell(int x, int y) const {
    return static_cast<CellIndex>(y) * static_cast<CellIndex>(width) + static_cast<CellIndex>(x);
  }
  int column(CellIndex cell) const { return static_cast<int>(cell % static_cast<CellIndex>(width)); }
  int row(CellIndex cell) const { return static_cast<int>(cell / static_cast<CellIndex>(width)); }
  CellIndex after(CellIndex cell, int x, int y) const {
    return static_cast<CellIndex>(static_cast<std::int64_t>(cell) + std::int64_t{y} * width + x);
  }
  /// In the map's frame G.
  geom::Vec2 centre(CellIndex cell) const {
    return {(column(cell) - 0.5) * scale, (row(cell) - 0.5) * scale};  // 1: the border
  }
  /// None off the map.
  std::optional<CellIndex> cell_of(geom::Vec2 p_G) const;
};

/// True of a cell so far from an obstacle's cell, from centre to centre, that it is too near to it. `cells`: the
/// distance.
bool is_too_near(double cells, double scale, const PlanOptions& options);

/// Clearance is measured from a cell's centre to the nearest obstacle's
/// edge, which is taken to be half a cell from that one's centre.
CostMap cost_map(const GridMap& map, const PlanOptions& options);

/// For each cell the squared distance, in cells, from its centre to that of the nearest obstacle.
std::vector<std::uint32_t> squares_from_obstacles(const CostMap& map);

/// To a neighbouring cell.
struct CellStep {
  int x, y;
  bool diagonal() const { return x != 0 && y != 0; }
};

/// In the order of the cells' numbers.
inline constexpr std::array<CellStep, 8> kCellSteps{
    {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

/// True if a step leads to a cell of at least this weight, and past none below it.
inline bool possible(const CostMap& map, CellIndex from, CellStep step, std::uint16_t least) {
  const auto fits = [&](int x, int y) { return map.weights[map.after(from, x, y)] >= least; };
  return fits(step.x, step.y) && (!step.diagonal() || (fits(step.x, 0) && fits(0, step.y)));
}

/// Of a step to a neighbouring free cell.
inline std::uint32_t step_cost(const CostMap& map, CellIndex from, CellIndex to, bool diagonal) {
  const std::uint32_t both = std::uint32_t{map.weights[from]} + map.weights[to];
  return diagonal ? both * 181 / 128 : both;  // the square root of 2
}
/// No step costs more.
std::uint32_t dearest_step(const CostMap& map);

}  // namespace playhouse::drivers
