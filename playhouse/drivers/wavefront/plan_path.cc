#include "playhouse/drivers/wavefront/plan_path.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "playhouse/drivers/wavefront/cost_buckets.h"

namespace playhouse::drivers {
namespace {

using geom::Vec2;

constexpr double kStraightening = 1.05;  // a leg may cost more than its steps by this factor

void spread(const CostMap& map, CellIndex goal, std::vector<std::uint32_t>& costs) {
  CostBuckets waiting(dearest_step(map));
  costs[goal] = 0;
  waiting.add(goal, 0);
  for (std::uint64_t cost = 0; !waiting.empty(); ++cost) {
    std::vector<CellIndex> cells = waiting.take(cost);
    for (const CellIndex cell : cells) {
      if (costs[cell] != cost) continue;  // a cheaper path was found
      for (const CellStep step : kCellSteps) {
        if (!possible(map, cell, step, CostMap::kPlain)) continue;
        const CellIndex next = map.after(cell, step.x, step.y);
        const std::uint64_t sum = cost + step_cost(map, cell, next, step.diagonal());
        if (sum >= costs[next]) continue;
        costs[next] = static_cast<std::uint32_t>(sum);
        waiting.add(next, sum);
      }
    }
    waiting.reuse(std::move(cells));
  }
}

// From the robot to the goal.

/// The nearest free cell that can be reached past no obstacle, unless the cell itself is free.
std::optional<CellIndex> nearest_free(const CostMap& map, CellIndex from) {
  if (map.free(from)) return from;
  std::vector<bool> seen(map.count());
  std::vector<CellIndex> ring{from}, found, next;
  seen[from] = true;
  while (!ring.empty() && found.empty()) {
    next.clear();
    for (const CellIndex cell : ring) {
      for (const CellStep step : kCellSteps) {
        const CellIndex to = map.after(cell, step.x, step.y);
        if (seen[to] || !possible(map, cell, step, CostMap::kNear)) continue;
        seen[to] = true;
        (map.free(to) ? found : next).push_back(to);
      }
    }
    std::swap(ring, next);
  }
  if (found.empty()) return std::nullopt;
  const auto far = [&](CellIndex cell) {
    const std::int64_t x = map.column(cell) - map.column(from), y = map.row(cell) - map.row(from);
    return std::pair(x * x + y * y, cell);
  };
  return *std::ranges::min_element(found, {}, far);
}

/// A path over cells.
struct CellPath {
  std::vector<CellIndex> cells;     // both ends included
  std::vector<std::uint32_t> left;  // what it costs from there on
};

CellPath cheapest_path(const CostMap& map, const CostToGoal& goal, CellIndex from) {
  CellPath path{{from}, {goal.costs[from]}};
  while (path.left.back() != 0) {
    const CellIndex cell = path.cells.back();
    std::uint64_t least = CostToGoal::kNone;
    CellIndex best = cell;
    for (const CellStep step : kCellSteps) {
      if (!possible(map, cell, step, CostMap::kPlain)) continue;
      const CellIndex next = map.after(cell, step.x, step.y);
      const std::uint64_t sum = std::uint64_t{goal.costs[next]} + step_cost(map, cell, next, step.diagonal());
      if (sum >= least) continue;
      least = sum;
      best = next;
    }
    path.cells.push_back(best);
    path.left.push_back(goal.costs[best]);
  }
  return path;
}

/// Cost of a straight leg between two cells' centres; none if it passes a cell that is not free.
std::optional<double> leg_cost(const CostMap& map, CellIndex from, CellIndex to) {
  const int dx = map.column(to) - map.column(from), dy = map.row(to) - map.row(from);
  const bool along_x = std::abs(dx) >= std::abs(dy);
  const int length = std::max(std::abs(dx), std::abs(dy)), across = std::min(std::abs(dx), std::abs(dy));
  if (length == 0) return 0;
  const int x = dx < 0 ? -1 : 1, y = dy < 0 ? -1 : 1;
  double sum = 0;
  for (int i = 0; i <= length; ++i) {
    // The line passes between two cells of this column or row, or through one.
    const std::int64_t place = std::int64_t{i} * across;
    const int low = static_cast<int>(place / length), off = static_cast<int>(place % length);
    const auto at = [&](int side) {
      return along_x ? map.after(from, i * x, side * y) : map.after(from, side * x, i * y);
    };
    const CellIndex near = at(low), other = off == 0 ? near : at(low + 1);
    if (!map.free(near) || !map.free(other)) return std::nullopt;
    if (across == length && i < length && !possible(map, near, {x, y}, CostMap::kPlain)) return std::nullopt;
    const double share = static_cast<double>(off) / length;
    const double weight = (1 - share) * map.weights[near] + share * map.weights[other];
    sum += i == 0 || i == length ? weight / 2 : weight;
  }
  return 2 * sum * std::sqrt(1 + static_cast<double>(across) / length * across / length);
}

/// The end of a straight leg from place `from` of the path: far, and at least the next place.
std::size_t leg_end(const CostMap& map, const CellPath& path, std::size_t from) {
  const auto straight = [&](std::size_t to) {
    const std::optional<double> cost = leg_cost(map, path.cells[from], path.cells[to]);
    return cost && *cost <= kStraightening * (path.left[from] - path.left[to]);
  };
  std::size_t good = from + 1, bad = path.cells.size();
  for (std::size_t step = 2; from + step < path.cells.size(); step *= 2) {
    if (!straight(from + step)) {
      bad = from + step;
      break;
    }
    good = from + step;
  }
  while (bad - good > 1) {
    const std::size_t middle = good + (bad - good) / 2;
    (straight(middle) ? good : bad) = middle;
  }
  return good;
}

/// From the robot's cell, in which the path may not begin, to the goal itself.
std::vector<Vec2> corners_of(const CostMap& map, const CellPath& path, CellIndex robot, Vec2 p_GT) {
  std::vector<Vec2> corners;
  if (path.cells.front() != robot) corners.push_back(map.centre(path.cells.front()));
  for (std::size_t place = 0; place + 1 < path.cells.size();) {
    place = leg_end(map, path, place);
    corners.push_back(map.centre(path.cells[place]));
  }
  if (path.cells.size() == 1) corners.push_back({});
  corners.back() = p_GT;
  return corners;
}

// Past obstacles that the costs to the goal do not know.

/// What a search from the start has found: of each cell the least cost, and the step by which it was reached.
struct Reached {
  explicit Reached(const CostMap& map) : costs(map.count(), CostToGoal::kNone), steps(map.count()) {}

  std::vector<std::uint32_t> costs;
  std::vector<std::uint8_t> steps;  // of kCellSteps
};

CellPath path_back(const CostMap& map, const Reached& reached, CellIndex start, CellIndex end) {
  CellPath path{{end}, {0}};
  for (CellIndex cell = end; cell != start;) {
    const CellStep step = kCellSteps[reached.steps[cell]];
    cell = map.after(cell, -step.x, -step.y);
    path.cells.push_back(cell);
    path.left.push_back(reached.costs[end] - reached.costs[cell]);
  }
  std::ranges::reverse(path.cells);
  std::ranges::reverse(path.left);
  return path;
}

/// A*: what is left without the new obstacles is never more than what is left with them, and falls along no step
/// by more than that costs.
std::optional<CellPath> cheapest_path_past(const CostMap& map, const CostToGoal& goal, CellIndex start,
                                           CellIndex end) {
  Reached reached(map);
  CostBuckets waiting(2 * dearest_step(map));
  reached.costs[start] = 0;
  waiting.add(start, goal.costs[start]);
  for (std::uint64_t total = goal.costs[start]; !waiting.empty(); ++total) {
    while (waiting.has(total)) {
      const CellIndex cell = waiting.take_last(total);
      const std::uint64_t cost = reached.costs[cell];
      if (cost + goal.costs[cell] != total) continue;  // a cheaper path was found
      if (cell == end) return path_back(map, reached, start, end);
      for (std::size_t i = 0; i < kCellSteps.size(); ++i) {
        const CellStep step = kCellSteps[i];
        if (!possible(map, cell, step, CostMap::kPlain)) continue;
        const CellIndex next = map.after(cell, step.x, step.y);
        const std::uint64_t sum = cost + step_cost(map, cell, next, step.diagonal());
        if (goal.costs[next] == CostToGoal::kNone || sum >= reached.costs[next]) continue;
        reached.costs[next] = static_cast<std::uint32_t>(sum);
        reached.steps[next] = static_cast<std::uint8_t>(i);
        waiting.add(next, sum + goal.costs[next]);
      }
    }
  }
  return std::nullopt;
}

}  // namespace

Result<CostToGoal> cost_to_goal(const CostMap& map, Vec2 p_GT) {
  const std::optional<CellIndex> goal = map.cell_of(p_GT);
  if (!goal) return Error{"", "the goal is off the map"};
  if (!map.free(*goal)) return Error{"", "the goal is within safety_dist of an obstacle"};
  CostToGoal result{p_GT, std::vector<std::uint32_t>(map.count(), CostToGoal::kNone)};
  spread(map, *goal, result.costs);
  return result;
}

Result<std::vector<Vec2>> path_to_goal(const CostMap& map, const CostToGoal& goal, Vec2 p_GR) {
  const std::optional<CellIndex> robot = map.cell_of(p_GR);
  if (!robot) return Error{"", "the robot is off the map"};
  const std::optional<CellIndex> start = nearest_free(map, *robot);
  if (!start) return Error{"", "the robot is among obstacles"};
  if (goal.costs[*start] == CostToGoal::kNone) return Error{"", "no way leads to the goal"};
  return corners_of(map, cheapest_path(map, goal, *start), *robot, goal.p_GT);
}

std::optional<PathPast> path_past(const CostMap& map, const CostToGoal& goal, Vec2 p_GR) {
  const std::optional<CellIndex> robot = map.cell_of(p_GR), end = map.cell_of(goal.p_GT);
  if (!robot || !end || !map.free(*end)) return std::nullopt;
  const std::optional<CellIndex> start = nearest_free(map, *robot);
  if (!start || goal.costs[*start] == CostToGoal::kNone) return std::nullopt;
  const std::optional<CellPath> path = cheapest_path_past(map, goal, *start, *end);
  if (!path) return std::nullopt;
  return PathPast{corners_of(map, *path, *robot, goal.p_GT), path->left.front() > goal.costs[*start]};
}

}  // namespace playhouse::drivers
