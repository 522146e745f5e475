// Paths on drawn maps, and costs against a slow and obvious computation.

#include "playhouse/drivers/wavefront/plan_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace playhouse::drivers {
namespace {

using geom::Vec2;
using ::testing::ElementsAre;
using Corners = std::vector<Vec2>;

constexpr float kScale = 0.125f;  // m per cell; a power of two, so that expected places are exact

/// Rows from the top: '#' occupied, '?' unknown, else free.
GridMap drawn(const std::vector<std::string>& rows) {
  GridMap map{
      {kScale, static_cast<std::uint32_t>(rows.front().size()), static_cast<std::uint32_t>(rows.size()), {}},
      {}};
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    for (const char mark : *row) map.cells.push_back(mark == '#' ? 1 : mark == '?' ? 0 : -1);
  return map;
}

GridMap open_map(int width, int height) {
  return drawn(std::vector<std::string>(static_cast<std::size_t>(height),
                                        std::string(static_cast<std::size_t>(width), '.')));
}

void fill(GridMap& map, int x0, int y0, int x1, int y1, std::int8_t value = 1) {
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) map.cells[static_cast<std::size_t>(y * map.width() + x)] = value;
}

/// Centre of a cell.
Vec2 at(int x, int y) {
  return {(x + 0.5) * kScale, (y + 0.5) * kScale};
}

Result<Corners> path(const GridMap& map, Vec2 from, Vec2 to, const PlanOptions& options = {}) {
  const CostMap costs = cost_map(map, options);
  const Result<CostToGoal> goal = cost_to_goal(costs, to);
  if (!goal) return goal.error();
  return path_to_goal(costs, *goal, from);
}

std::string fault(const GridMap& map, Vec2 from, Vec2 to, const PlanOptions& options = {}) {
  const Result<Corners> found = path(map, from, to, options);
  return found ? "" : found.error().text;
}

/// From a point to the nearest obstacle's edge, what is beyond the map included. [m]
double clearance(const GridMap& map, Vec2 p) {
  const double x = p.x / kScale, y = p.y / kScale;  // cells
  double nearest = std::min({x, y, map.width() - x, map.height() - y});
  for (int row = 0; row < map.height(); ++row)
    for (int col = 0; col < map.width(); ++col) {
      if (map.cells[static_cast<std::size_t>(row * map.width() + col)] < 0) continue;
      const double dx = std::max({col - x, x - col - 1, 0.0}), dy = std::max({row - y, y - row - 1, 0.0});
      nearest = std::min(nearest, std::sqrt(dx * dx + dy * dy));
    }
  return nearest * kScale;
}

/// Least clearance of a path, looked at ten times per cell.
double least_clearance(const GridMap& map, Vec2 from, const Corners& corners) {
  double least = 1e9;
  for (const Vec2 to : corners) {
    const Vec2 leg = to - from;
    const int steps = 1 + static_cast<int>(10 * std::sqrt(dot(leg, leg)) / kScale);
    for (int i = 0; i <= steps; ++i)
      least = std::min(least, clearance(map, from + static_cast<double>(i) / steps * leg));
    from = to;
  }
  return least;
}

double length(Vec2 from, const Corners& corners) {
  double sum = 0;
  for (const Vec2 to : corners) {
    sum += std::sqrt(dot(to - from, to - from));
    from = to;
  }
  return sum;
}

/// A leg passes less than half a cell beside a free cell's centre, whose distance
/// from a corner is up to 0.21 cells less than that from an edge half a cell from its centre.
constexpr double kSlack = 0.71 * kScale;

TEST(PlanPath, in_the_open_leads_straight_to_the_goal_whatever_the_direction) {
  const GridMap map = open_map(60, 60);
  for (const Vec2 goal : {at(50, 30), at(30, 9), at(50, 50), at(12, 47), at(45, 37)}) {
    const Result<Corners> found = path(map, at(30, 30), goal, {0.25, 0.25, 1});
    ASSERT_TRUE(found);
    EXPECT_THAT(*found, ElementsAre(goal));
  }
  const Vec2 not_the_middle{3.01, 4.07};
  EXPECT_THAT(*path(map, {3.02, 3.99}, not_the_middle), ElementsAre(not_the_middle));
}

TEST(PlanPath, goes_round_a_wall_at_the_end_where_it_is_open) {
  GridMap map = open_map(80, 60);
  fill(map, 40, 0, 42, 40);
  const Vec2 from = at(20, 10), to = at(60, 10);
  const Result<Corners> found = path(map, from, to);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->back(), to);
  EXPECT_GE(found->size(), 2u);
  EXPECT_LE(found->size(), 8u);
  EXPECT_GE(least_clearance(map, from, *found), 0.25 - kSlack);
  const auto round_by = [&](const Corners& corners) { return length(from, corners); };
  EXPECT_GT(length(from, *found), round_by({at(39, 40), at(42, 40), to}));
  // A metre off the wall costs no penalty; steps of 45 degrees are 1.083 times as long, a leg costs 1.05
  // times as much as they do.
  EXPECT_LT(length(from, *found),
            1.05 * 1.083 * round_by({at(31, 40), at(38, 49), at(43, 49), at(50, 40), to}));
}

TEST(PlanPath, a_gap_narrower_than_twice_the_safety_distance_is_closed) {
  const auto through = [](int gap) {
    GridMap map = open_map(60, 40);
    fill(map, 30, 0, 31, 40);
    fill(map, 30, 20, 31, 20 + gap, -1);
    return fault(map, at(10, 20), at(50, 20), {0.3125, 1, 1});  // 2.5 cells
  };
  EXPECT_EQ(through(4), "no way leads to the goal");
  EXPECT_EQ(through(5), "");
}

TEST(PlanPath, takes_the_wide_gap_if_clearance_is_worth_the_way) {
  GridMap map = open_map(60, 100);
  fill(map, 30, 0, 31, 100);
  fill(map, 30, 10, 31, 16, -1);  // straight ahead, narrow
  fill(map, 30, 40, 31, 60, -1);  // wide
  const Vec2 from = at(10, 13), to = at(50, 13);
  const auto highest = [&](double penalty) {
    const Result<Corners> found = path(map, from, to, {0.25, 1, penalty});
    return std::ranges::max_element(*found, {}, &Vec2::y)->y;
  };
  EXPECT_LT(highest(0), at(0, 16).y);
  EXPECT_GT(highest(30), at(0, 40).y);
}

TEST(PlanPath, keeps_away_from_a_wall_that_it_runs_along_as_it_is_told) {
  GridMap map = open_map(120, 40);
  const Vec2 from = at(10, 3), to = at(110, 3);
  EXPECT_THAT(*path(map, from, to, {0.25, 1, 0}), ElementsAre(to));
  const Result<Corners> off = path(map, from, to, {0.25, 1, 2});
  ASSERT_GE(off->size(), 3u);
  EXPECT_GT(clearance(map, 0.5 * ((*off)[0] + (*off)[off->size() - 2])), 0.75);
}

TEST(PlanPath, counts_unknown_cells_and_what_is_beyond_the_map_as_obstacles) {
  GridMap map = open_map(40, 40);
  fill(map, 20, 0, 21, 39, 0);
  EXPECT_EQ(fault(map, at(10, 10), at(30, 10)), "no way leads to the goal");
  EXPECT_EQ(fault(map, at(10, 10), at(1, 10)), "the goal is within safety_dist of an obstacle");
  EXPECT_EQ(fault(map, at(10, 10), at(2, 10)), "");
}

TEST(PlanPath, says_why_there_is_none) {
  GridMap map = open_map(40, 40);
  fill(map, 20, 0, 21, 40);
  fill(map, 0, 20, 5, 40);
  const Vec2 here = at(10, 10);
  EXPECT_EQ(fault(map, here, at(30, 10)), "no way leads to the goal");
  EXPECT_EQ(fault(map, here, at(20, 10)), "the goal is within safety_dist of an obstacle");
  EXPECT_EQ(fault(map, here, {-0.01, 1}), "the goal is off the map");
  EXPECT_EQ(fault(map, here, {1, 40 * kScale}), "the goal is off the map");
  EXPECT_EQ(fault(map, here, {1e300, 1}), "the goal is off the map");
  EXPECT_EQ(fault(map, {1, -0.01}, here), "the robot is off the map");
  EXPECT_EQ(fault(map, at(2, 30), here), "the robot is among obstacles");
}

TEST(PlanPath, too_near_to_a_wall_it_first_leaves_it_and_not_through_it) {
  // A dead end, too narrow everywhere: its free cells are to the left, nearer ones behind its thin wall.
  GridMap map = open_map(60, 60);
  fill(map, 20, 30, 40, 31);
  fill(map, 20, 33, 40, 34);
  fill(map, 39, 30, 40, 34);
  const Vec2 from = at(36, 32), to = at(50, 10);
  const Result<Corners> found = path(map, from, to, {0.25, 1, 1});
  ASSERT_TRUE(found);
  const Vec2 first = found->front();
  EXPECT_LT(first.x, at(20, 0).x);
  EXPECT_GE(clearance(map, first), 0.25);
  EXPECT_EQ(found->back(), to);
  // Beside one wall: straight away from it.
  EXPECT_EQ(path(map, at(30, 29), to)->front(), at(30, 27));
  EXPECT_THAT(*path(map, at(30, 29), at(30, 27)), ElementsAre(at(30, 27), at(30, 27)));
}

TEST(PlanPath, passes_no_corner_where_obstacles_touch) {
  const GridMap map = drawn({"...#",  //
                             "...#",  //
                             "###.",  //
                             "#..."});
  EXPECT_EQ(fault(map, at(1, 2), at(3, 1), {0, 0, 0}), "no way leads to the goal");
}

TEST(PlanPath, a_leg_cuts_no_corner_of_an_obstacle_either) {
  GridMap map = open_map(20, 20);
  fill(map, 9, 10, 10, 11);
  fill(map, 10, 9, 11, 10);
  const Result<Corners> found = path(map, at(9, 9), at(10, 10), {0, 0, 0});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->front(), at(9, 8)) << "not (10, 8)";
}

TEST(PlanPath, gives_these_bits) {
  GridMap map = open_map(60, 40);
  fill(map, 20, 0, 22, 30);
  fill(map, 40, 10, 42, 40);
  const Result<Corners> found = path(map, at(5, 5), at(55, 35));
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, *path(map, at(5, 5), at(55, 35)));
  EXPECT_THAT(*found, ElementsAre(at(8, 18), at(18, 32), at(23, 32), at(30, 21), at(38, 7), at(43, 7),
                                  at(50, 18), at(55, 35)));
}

// The oracle.

std::vector<double> slow_weights(const GridMap& map, const PlanOptions& options) {
  std::vector<double> weights;
  const auto obstacle = [&](int x, int y) {
    return x < 0 || y < 0 || x >= map.width() || y >= map.height() ||
           map.cells[static_cast<std::size_t>(y * map.width() + x)] >= 0;
  };
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x) {
      double nearest = 1e9;
      for (int v = -1; v <= map.height(); ++v)
        for (int u = -1; u <= map.width(); ++u)
          if (obstacle(u, v)) nearest = std::min(nearest, std::sqrt((u - x) * (u - x) + (v - y) * (v - y)));
      const double clear = (nearest - 0.5) * map.info.scale;
      double nearness = (options.max_radius - clear) / (options.max_radius - options.safety_distance);
      if (options.max_radius <= options.safety_distance) nearness = 0;
      const bool blocked = nearest == 0 || clear < options.safety_distance;
      weights.push_back(blocked ? 0
                                : std::round(64 * (1 + options.penalty * std::clamp(nearness, 0.0, 1.0))));
    }
  return weights;
}

/// Costs to the goal, or -1: lowers them until nothing changes.
std::vector<double> slow_costs(const GridMap& map, const std::vector<double>& weights, int goal) {
  std::vector<double> costs(weights.size(), -1);
  costs[static_cast<std::size_t>(goal)] = 0;
  const auto weight = [&](int x, int y) {
    return x < 0 || y < 0 || x >= map.width() || y >= map.height()
               ? 0
               : weights[static_cast<std::size_t>(y * map.width() + x)];
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (int y = 0; y < map.height(); ++y)
      for (int x = 0; x < map.width(); ++x)
        for (int v = y - 1; v <= y + 1; ++v)
          for (int u = x - 1; u <= x + 1; ++u) {
            if (weight(x, y) == 0 || weight(u, v) == 0 || weight(x, v) == 0 || weight(u, y) == 0) continue;
            double& here = costs[static_cast<std::size_t>(y * map.width() + x)];
            const double there = costs[static_cast<std::size_t>(v * map.width() + u)];
            const double both = weight(x, y) + weight(u, v);
            const double step = x != u && y != v ? std::floor(both * 181 / 128) : both;
            if (there < 0 || (x == u && y == v) || (here >= 0 && here <= there + step)) continue;
            here = there + step;
            changed = true;
          }
  }
  return costs;
}

RC_GTEST_PROP(PlanPath, costs_are_those_of_the_slow_and_obvious_computation, ()) {
  GridMap map = open_map(*rc::gen::inRange(1, 25), *rc::gen::inRange(1, 25));
  const int percent = *rc::gen::inRange(0, 30);
  for (std::int8_t& cell : map.cells)
    if (*rc::gen::inRange(0, 100) < percent) cell = *rc::gen::element<std::int8_t>(0, 1);
  const PlanOptions options{*rc::gen::inRange(0, 8) / 32.0, *rc::gen::inRange(0, 40) / 32.0,
                            *rc::gen::inRange(0, 12) / 4.0};
  const int cells = map.width() * map.height(), goal = *rc::gen::inRange(0, cells);
  const auto place = [&](int cell) { return at(cell % map.width(), cell / map.width()); };
  const std::vector<double> weights = slow_weights(map, options), costs = slow_costs(map, weights, goal);

  const CostMap fast = cost_map(map, options);
  const Result<CostToGoal> to_goal = cost_to_goal(fast, place(goal));
  RC_CLASSIFY(to_goal.ok(), "a goal that is free");
  RC_ASSERT(to_goal.ok() == (weights[static_cast<std::size_t>(goal)] > 0));
  if (!to_goal) return;
  for (int cell = 0; cell < cells; ++cell) {
    const int x = cell % map.width() + 1, y = cell / map.width() + 1;
    const std::uint32_t cost = to_goal->costs[static_cast<std::size_t>(y * fast.width + x)];
    const double expected = costs[static_cast<std::size_t>(cell)];
    RC_ASSERT((expected < 0 ? cost == CostToGoal::kNone : cost == expected));
    const Result<Corners> found = path_to_goal(fast, *to_goal, place(cell));
    if (weights[static_cast<std::size_t>(cell)] == 0) continue;
    RC_ASSERT(found.ok() == (expected >= 0));
    if (!found) continue;
    RC_ASSERT(found->back() == place(goal));
    RC_ASSERT(least_clearance(map, place(cell), *found) >= options.safety_distance - kSlack);
    // A plain path of this length costs no more: legs are no dearer than what they replace.
    RC_ASSERT(length(place(cell), *found) / kScale * 128 <= 1.05 * expected + 1e-6);
  }
}

// Past what is new.

TEST(PlanPath, past_something_new_the_path_is_as_on_a_map_that_has_it) {
  GridMap map = open_map(60, 60);
  fill(map, 20, 0, 22, 40);
  const CostMap before = cost_map(map, {});
  const CostToGoal goal = *cost_to_goal(before, at(40, 10));
  const std::optional<PathPast> same = path_past(before, goal, at(10, 10));
  ASSERT_TRUE(same);
  EXPECT_FALSE(same->is_detour);
  fill(map, 20, 40, 22, 50);
  const CostMap after = cost_map(map, {});
  const std::optional<PathPast> past = path_past(after, goal, at(10, 10));
  ASSERT_TRUE(past);
  EXPECT_TRUE(past->is_detour);
  EXPECT_GE(least_clearance(map, at(10, 10), past->corners), 0.25 - kSlack);
  fill(map, 20, 50, 22, 60);
  EXPECT_FALSE(path_past(cost_map(map, {}), goal, at(10, 10)));
}

RC_GTEST_PROP(PlanPath, past_what_is_new_paths_cost_as_much_as_on_a_map_that_has_it, ()) {
  GridMap map = open_map(*rc::gen::inRange(1, 25), *rc::gen::inRange(1, 25));
  const auto strew = [&map](int most) {
    const int percent = *rc::gen::inRange(0, most);
    for (std::int8_t& cell : map.cells)
      if (*rc::gen::inRange(0, 100) < percent) cell = 1;
  };
  strew(20);
  const PlanOptions options{*rc::gen::inRange(0, 6) / 32.0, 1, *rc::gen::inRange(0, 12) / 4.0};
  const auto place = [&](int cell) { return at(cell % map.width(), cell / map.width()); };
  const int cells = map.width() * map.height();
  const Vec2 to = place(*rc::gen::inRange(0, cells));
  const Result<CostToGoal> old_goal = cost_to_goal(cost_map(map, options), to);
  if (!old_goal) return;
  strew(25);
  const CostMap costs = cost_map(map, options);
  const Result<CostToGoal> new_goal = cost_to_goal(costs, to);
  for (int cell = 0; cell < cells; ++cell) {
    const Vec2 from = place(cell);
    const std::optional<PathPast> past = path_past(costs, *old_goal, from);
    RC_ASSERT(past.has_value() == (new_goal.ok() && path_to_goal(costs, *new_goal, from).ok()));
    const CellIndex start = *costs.cell_of(from);
    if (!past || !costs.free(start)) continue;
    RC_CLASSIFY(past->is_detour, "a detour");
    const std::uint32_t cost = new_goal->costs[start];
    RC_ASSERT(past->is_detour == (cost > old_goal->costs[start]));
    RC_ASSERT(past->corners.back() == to);
    RC_ASSERT(least_clearance(map, from, past->corners) >= options.safety_distance - kSlack);
    RC_ASSERT(length(from, past->corners) / kScale * 128 <= 1.05 * cost + 1e-6);
  }
}

}  // namespace
}  // namespace playhouse::drivers
