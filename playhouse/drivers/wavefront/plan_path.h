#pragma once

/// Plans paths on a grid map that keep a distance from obstacles.
/// Pure functions; their results are the same bits on every machine.
///
/// In: a map with the costs of its cells (cost_map.h); a goal and the robot's place in the map's frame G [m].
///
/// Out: the corners of a path from the robot to the goal, or why there is none. The path over cells is the
///   cheapest one; a straight leg replaces a stretch of it that is no cheaper.
///
/// Cost: cost_to_goal() is linear in the cells, once per goal; path_to_goal() is linear in the path's cells,
///   times a logarithm. In a release build 500 x 500 cells take 9 to 23 and up to 1 ms, 4000 x 4000 cells 0.8 to
///   1.7 and up to 0.1 s (rooms, a winding corridor). path_past() fills 5 bytes per cell and visits those from
///   which a way costs no more than that which it finds: few where a way leads round an obstacle, all where none
///   does, which takes as long as cost_to_goal().
///
/// Source: R. Dial: "Algorithm 360: Shortest-path forest with topological ordering", CACM 1969, Dijkstra's
/// algorithm with buckets; P. Hart, N. Nilsson, B. Raphael: "A Formal Basis for the Heuristic Determination of
/// Minimum Cost Paths", 1968, for path_past().

#include <cstdint>
#include <optional>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/drivers/wavefront/cost_map.h"
#include "playhouse/geom/pose.h"

namespace playhouse::drivers {

/// Costs of the cheapest paths to a goal.
struct CostToGoal {
  static constexpr std::uint32_t kNone = 0xffffffff;  // no path, or one that costs more than 33 M plain cells

  geom::Vec2 p_GT;
  std::vector<std::uint32_t> costs;  // per cell; 2 * kPlain for each plain cell of a path along an axis
};

/// Fails if the goal is off the map, or no place for the robot.
Result<CostToGoal> cost_to_goal(const CostMap& map, geom::Vec2 p_GT);

/// The corners of a path in G, without the robot's place and ending at the goal. If the robot is too near to
/// an obstacle, its first corner is the nearest free cell, not counting those behind obstacles. Fails if
/// there is no path.
Result<std::vector<geom::Vec2>> path_to_goal(const CostMap& map, const CostToGoal& goal, geom::Vec2 p_GR);

/// A way past obstacles that are new since the costs to the goal were computed.
struct PathPast {
  std::vector<geom::Vec2> corners;  // as those of path_to_goal()
  bool is_detour = false;           // without the new obstacles there is a cheaper one
};

/// `map`: that of the goal with more obstacles. None if there is no path; path_to_goal() may say why.
std::optional<PathPast> path_past(const CostMap& map, const CostToGoal& goal, geom::Vec2 p_GR);

}  // namespace playhouse::drivers
