#pragma once

/// Plans paths on a grid map that keep a distance from obstacles.
/// Pure functions; their results are the same bits on every machine.
///
/// In: a map, whose unknown cells, and what is beyond it, count as obstacles; a goal and the robot's place
///   in the map's frame G [m].
///
/// Out: the corners of a path from the robot to the goal, or why there is none. The path over cells is the
///   cheapest one; a straight leg replaces a stretch of it that is no cheaper.
///
/// Cost: cost_map() is linear in the cells, once per map; cost_to_goal() as well, once per goal;
///   path_to_goal() is linear in the path's cells, times a logarithm. In a release build 500 x 500 cells take
///   4, 9 to 23 and up to 1 ms, 4000 x 4000 cells 0.2, 0.8 to 1.7 and up to 0.1 s (rooms, a winding
///   corridor).
///
/// Source: R. Dial: "Algorithm 360: Shortest-path forest with topological ordering", CACM 1969, Dijkstra's
/// algorithm with buckets; distances.h for the distances from obstacles.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "playhouse/base/result.h"
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

/// A map for planning: its cells with a border of obstacles, by rows from the bottom.
struct CostMap {
  // Weights of cells that are no part of a path.
  static constexpr std::uint16_t kObstacle = 0;
  static constexpr std::uint16_t kNear = 1;    // to an obstacle
  static constexpr std::uint16_t kPlain = 64;  // weight of a cell far from obstacles, the least of free ones

  int width = 0, height = 0;  // with the border
  double scale = 0;           // m per cell
  std::vector<std::uint16_t> weights;

  bool free(CellIndex cell) const { return weights[cell] >= kPlain; }
};

/// Costs of the cheapest paths to a goal.
struct CostToGoal {
  static constexpr std::uint32_t kNone = 0xffffffff;  // no path, or one that costs more than 33 M plain cells

  geom::Vec2 p_GT;
  std::vector<std::uint32_t> costs;  // per cell; 2 * kPlain for each plain cell of a path along an axis
};

/// Clearance is measured from a cell's centre to the nearest obstacle's
/// edge, which is taken to be half a cell from that one's centre.
CostMap cost_map(const GridMap& map, const PlanOptions& options);

/// Fails if the goal is off the map, or no place for the robot.
Result<CostToGoal> cost_to_goal(const CostMap& map, geom::Vec2 p_GT);

/// The corners of a path in G, without the robot's place and ending at the goal. If the robot is too near to
/// an obstacle, its first corner is the nearest free cell, not counting those behind obstacles. Fails if
/// there is no path.
Result<std::vector<geom::Vec2>> path_to_goal(const CostMap& map, const CostToGoal& goal, geom::Vec2 p_GR);

}  // namespace playhouse::drivers
