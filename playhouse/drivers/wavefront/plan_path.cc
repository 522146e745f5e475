#include "playhouse/drivers/wavefront/plan_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "playhouse/drivers/grid_map/distances.h"

namespace playhouse::drivers {
namespace {

using geom::Vec2;

constexpr double kRounding = 1e-4;       // cells; the wire's cell size has 24 bits
constexpr double kStraightening = 1.05;  // a leg may cost more than its steps by this factor

std::size_t count(const CostMap& map) {
  return static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height);
}

CellIndex cell_at(const CostMap& map, int x, int y) {
  return static_cast<CellIndex>(y) * static_cast<CellIndex>(map.width) + static_cast<CellIndex>(x);
}
int column(const CostMap& map, CellIndex cell) {
  return static_cast<int>(cell % static_cast<CellIndex>(map.width));
}
int row(const CostMap& map, CellIndex cell) {
  return static_cast<int>(cell / static_cast<CellIndex>(map.width));
}

Vec2 centre(const CostMap& map, CellIndex cell) {
  return {(column(map, cell) - 0.5) * map.scale, (row(map, cell) - 0.5) * map.scale};  // 1: the border
}

/// None off the map.
std::optional<CellIndex> cell_of(const CostMap& map, Vec2 p_G) {
  const double x = std::floor(p_G.x / map.scale) + 1, y = std::floor(p_G.y / map.scale) + 1;
  if (!(x >= 1 && y >= 1 && x <= map.width - 2 && y <= map.height - 2)) return std::nullopt;
  return cell_at(map, static_cast<int>(x), static_cast<int>(y));
}

/// Weight of a cell that is no obstacle. `clearance`: cells.
std::uint16_t weight(double clearance, double scale, const PlanOptions& options) {
  const double safety = options.safety_distance / scale, most = options.max_radius / scale;
  if (clearance < safety - kRounding) return CostMap::kNear;
  const double nearness = most > safety ? std::clamp((most - clearance) / (most - safety), 0.0, 1.0) : 0;
  return static_cast<std::uint16_t>(std::floor(CostMap::kPlain * (1 + options.penalty * nearness) + 0.5));
}

/// The cells with the border, as obstacles and others.
CostMap obstacles_of(const GridMap& grid) {
  CostMap map{grid.width() + 2, grid.height() + 2, grid.info.scale, {}};
  map.weights.assign(count(map), CostMap::kObstacle);
  for (int y = 0; y < grid.height(); ++y)
    for (int x = 0; x < grid.width(); ++x)
      if (grid.cells[static_cast<std::size_t>(y) * grid.info.width + static_cast<std::size_t>(x)] < 0)
        map.weights[cell_at(map, x + 1, y + 1)] = CostMap::kPlain;
  return map;
}

// Steps between cells.

struct Step {
  int x, y;
  bool diagonal() const { return x != 0 && y != 0; }
};

/// In the order of the cells' numbers.
constexpr std::array<Step, 8> kSteps{{{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

CellIndex after(const CostMap& map, CellIndex cell, int x, int y) {
  return static_cast<CellIndex>(static_cast<std::int64_t>(cell) + std::int64_t{y} * map.width + x);
}

/// True if a step leads to a cell of at least this weight, and past none below it.
bool possible(const CostMap& map, CellIndex from, Step step, std::uint16_t least) {
  const auto fits = [&](int x, int y) { return map.weights[after(map, from, x, y)] >= least; };
  return fits(step.x, step.y) && (!step.diagonal() || (fits(step.x, 0) && fits(0, step.y)));
}

/// Of a step to a neighbouring free cell.
std::uint32_t step_cost(const CostMap& map, CellIndex from, CellIndex to, bool diagonal) {
  const std::uint32_t both = std::uint32_t{map.weights[from]} + map.weights[to];
  return diagonal ? both * 181 / 128 : both;  // the square root of 2
}

/// Cells that wait for their turn, by cost: a ring of buckets, as no step costs more than the ring is long.
class Waiting {
 public:
  explicit Waiting(std::uint32_t most_step) : buckets_(std::size_t{most_step} + 1) {}

  void add(CellIndex cell, std::uint64_t cost) {
    buckets_[cost % buckets_.size()].push_back(cell);
    ++count_;
  }
  bool empty() const { return count_ == 0; }
  /// All cells of this cost.
  std::vector<CellIndex> take(std::uint64_t cost) {
    std::vector<CellIndex> cells = std::exchange(buckets_[cost % buckets_.size()], std::move(spare_));
    count_ -= cells.size();
    return cells;
  }
  /// Gives a taken vector back, for its memory.
  void reuse(std::vector<CellIndex> cells) {
    spare_ = std::move(cells);
    spare_.clear();
  }

 private:
  std::vector<std::vector<CellIndex>> buckets_;
  std::vector<CellIndex> spare_;
  std::size_t count_ = 0;
};

void spread(const CostMap& map, CellIndex goal, std::vector<std::uint32_t>& costs) {
  const std::uint32_t most = *std::ranges::max_element(map.weights);
  Waiting waiting(2 * most * 181 / 128);
  costs[goal] = 0;
  waiting.add(goal, 0);
  for (std::uint64_t cost = 0; !waiting.empty(); ++cost) {
    std::vector<CellIndex> cells = waiting.take(cost);
    for (const CellIndex cell : cells) {
      if (costs[cell] != cost) continue;  // a cheaper path was found
      for (const Step step : kSteps) {
        if (!possible(map, cell, step, CostMap::kPlain)) continue;
        const CellIndex next = after(map, cell, step.x, step.y);
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
  std::vector<bool> seen(count(map));
  std::vector<CellIndex> ring{from}, found, next;
  seen[from] = true;
  while (!ring.empty() && found.empty()) {
    next.clear();
    for (const CellIndex cell : ring) {
      for (const Step step : kSteps) {
        const CellIndex to = after(map, cell, step.x, step.y);
        if (seen[to] || !possible(map, cell, step, CostMap::kNear)) continue;
        seen[to] = true;
        (map.free(to) ? found : next).push_back(to);
      }
    }
    std::swap(ring, next);
  }
  if (found.empty()) return std::nullopt;
  const auto far = [&](CellIndex cell) {
    const std::int64_t x = column(map, cell) - column(map, from), y = row(map, cell) - row(map, from);
    return std::pair(x * x + y * y, cell);
  };
  return *std::ranges::min_element(found, {}, far);
}

/// All cells of the cheapest path, both ends included.
std::vector<CellIndex> cheapest_path(const CostMap& map, const CostToGoal& goal, CellIndex from) {
  std::vector<CellIndex> path{from};
  while (goal.costs[path.back()] != 0) {
    const CellIndex cell = path.back();
    std::uint64_t least = CostToGoal::kNone;
    CellIndex best = cell;
    for (const Step step : kSteps) {
      if (!possible(map, cell, step, CostMap::kPlain)) continue;
      const CellIndex next = after(map, cell, step.x, step.y);
      const std::uint64_t sum = std::uint64_t{goal.costs[next]} + step_cost(map, cell, next, step.diagonal());
      if (sum >= least) continue;
      least = sum;
      best = next;
    }
    path.push_back(best);
  }
  return path;
}

/// Cost of a straight leg between two cells' centres; none if it passes a cell that is not free.
std::optional<double> leg_cost(const CostMap& map, CellIndex from, CellIndex to) {
  const int dx = column(map, to) - column(map, from), dy = row(map, to) - row(map, from);
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
      return along_x ? after(map, from, i * x, side * y) : after(map, from, side * x, i * y);
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
std::size_t leg_end(const CostMap& map, const CostToGoal& goal, const std::vector<CellIndex>& path,
                    std::size_t from) {
  const auto straight = [&](std::size_t to) {
    const std::optional<double> cost = leg_cost(map, path[from], path[to]);
    return cost && *cost <= kStraightening * (goal.costs[path[from]] - goal.costs[path[to]]);
  };
  std::size_t good = from + 1, bad = path.size();
  for (std::size_t step = 2; from + step < path.size(); step *= 2) {
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

}  // namespace

CostMap cost_map(const GridMap& grid, const PlanOptions& options) {
  CostMap map = obstacles_of(grid);
  std::vector<std::uint8_t> obstacles;
  obstacles.reserve(count(map));
  for (const std::uint16_t weight : map.weights) obstacles.push_back(weight == CostMap::kObstacle ? 1 : 0);
  const std::vector<std::uint32_t> squares = squared_distances(map.width, map.height, obstacles);
  for (CellIndex cell = 0; cell < squares.size(); ++cell) {
    if (map.weights[cell] == CostMap::kObstacle) continue;
    const double clearance = std::sqrt(static_cast<double>(squares[cell])) - 0.5;
    map.weights[cell] = weight(clearance, map.scale, options);
  }
  return map;
}

Result<CostToGoal> cost_to_goal(const CostMap& map, Vec2 p_GT) {
  const std::optional<CellIndex> goal = cell_of(map, p_GT);
  if (!goal) return Error{"", "the goal is off the map"};
  if (!map.free(*goal)) return Error{"", "the goal is within safety_dist of an obstacle"};
  CostToGoal result{p_GT, std::vector<std::uint32_t>(count(map), CostToGoal::kNone)};
  spread(map, *goal, result.costs);
  return result;
}

Result<std::vector<Vec2>> path_to_goal(const CostMap& map, const CostToGoal& goal, Vec2 p_GR) {
  const std::optional<CellIndex> robot = cell_of(map, p_GR);
  if (!robot) return Error{"", "the robot is off the map"};
  const std::optional<CellIndex> start = nearest_free(map, *robot);
  if (!start) return Error{"", "the robot is among obstacles"};
  if (goal.costs[*start] == CostToGoal::kNone) return Error{"", "no way leads to the goal"};
  const std::vector<CellIndex> path = cheapest_path(map, goal, *start);
  std::vector<Vec2> corners;
  if (start != robot) corners.push_back(centre(map, *start));
  for (std::size_t place = 0; place + 1 < path.size();) {
    place = leg_end(map, goal, path, place);
    corners.push_back(centre(map, path[place]));
  }
  if (path.size() == 1) corners.push_back({});
  corners.back() = goal.p_GT;
  return corners;
}

}  // namespace playhouse::drivers
