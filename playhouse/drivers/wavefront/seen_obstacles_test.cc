// What scans put on a map and take away from it, against a map that has it.

#include "playhouse/drivers/wavefront/seen_obstacles.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace playhouse::drivers {
namespace {

using geom::Pose;
using geom::radians;
using geom::Vec2;

constexpr float kScale = 0.125f;  // m per cell
constexpr Pose kMiddle{2.5625, 2.5625, 0, 0};

GridMap open_floor() {
  return {{kScale, 40, 40, {}}, std::vector<std::int8_t>(40 * 40, -1)};
}

/// A scan of beams with these ranges, one ahead and one at each side of it, `step` apart.
RangeScan ahead(std::vector<float> ranges, double step = radians(2)) {
  RangeScan scan{{{}}, std::move(ranges), 0, step};
  scan.first_angle = -step * static_cast<double>(scan.beams() - 1) / 2;
  scan.max_range = 3;
  return scan;
}

class Seen {
 public:
  explicit Seen(const GridMap& map = open_floor(), const SeenOptions& sight = {},
                const PlanOptions& plan = {})
      : costs(std::make_shared<const CostMap>(cost_map(map, plan))), obstacles(costs, plan, sight) {}

  void look(const RangeScan& scan, double time, const Pose& X_GR = kMiddle) {
    obstacles.pass_time(time);
    obstacles.take(scan, X_GR);
  }
  bool is_obstacle(Vec2 p_G) const { return obstacles.is_obstacle(*costs->cell_of(p_G)); }

  std::shared_ptr<const CostMap> costs;
  SeenObstacles obstacles;
};

/// Nine beams, which look farther than the one in the middle.
RangeScan nine(float middle, float beside = 3) {
  RangeScan scan = ahead(std::vector<float>(9, 3));
  scan.ranges[4] = middle;
  scan.ranges[5] = beside;
  return scan;
}

const RangeScan kOneAhead = nine(1), kNothing = nine(3);
const Vec2 kThere = kMiddle.xy() + Vec2{1, 0};

TEST(SeenObstacles, are_where_a_beam_ends_from_where_the_robot_and_its_sensor_were) {
  Seen seen;
  RangeScan scan = kOneAhead;
  scan.eyes[0].X_RS = {0, 0.5, 0, radians(90)};
  seen.look(scan, 1, {2.5, 2.5, 0, radians(90)});
  EXPECT_TRUE(seen.is_obstacle({1, 2.5}));
  EXPECT_EQ(seen.obstacles.come(), 1u);
}

TEST(SeenObstacles, a_beam_at_its_limit_or_beyond_the_range_or_of_no_length_shows_nothing) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(),
                  kInf = std::numeric_limits<float>::infinity();
  for (const float range : {3.0f, 3.5f, 0.0f, -1.0f, kNan, kInf, 1e30f}) {
    Seen seen;
    seen.look(ahead({range}), 1);
    EXPECT_FALSE(seen.obstacles.any()) << range;
  }
  Seen near(open_floor(), {.range = 0.9});
  near.look(kOneAhead, 1);
  EXPECT_FALSE(near.obstacles.any());
}

TEST(SeenObstacles, what_is_on_the_map_or_off_it_is_none) {
  GridMap map = open_floor();
  map.cells[20 * 40 + 28] = 1;  // at 3.5625, 2.5625
  Seen seen(map);
  seen.look(ahead({0.9f}), 1);
  seen.look(ahead({1.2f}), 2);
  EXPECT_FALSE(seen.obstacles.any());
  seen.look(ahead({0.6f}), 3);
  EXPECT_TRUE(seen.obstacles.any());
  Seen off;
  off.look(ahead({2.9f}), 1, {4, 2, 0, 0});
  EXPECT_FALSE(off.obstacles.any());
}

TEST(SeenObstacles, last_for_their_time_after_they_were_seen_last) {
  Seen seen;
  seen.look(kOneAhead, 1);
  seen.look(kOneAhead, 5);
  seen.obstacles.pass_time(34.9);
  EXPECT_TRUE(seen.is_obstacle(kThere));
  seen.obstacles.pass_time(35.1);
  EXPECT_FALSE(seen.obstacles.any());
  EXPECT_EQ(seen.obstacles.gone(), 1u);
  EXPECT_EQ(seen.obstacles.costs().weights, seen.costs->weights);
}

TEST(SeenObstacles, last_twice_as_long_each_time_that_they_are_found_again_up_to_a_limit) {
  Seen seen;
  double time = 0;
  for (const double lasts : {30, 60, 120, 240, 480, 960, 960}) {
    seen.look(kOneAhead, time);
    seen.obstacles.pass_time(time + lasts - 1);
    EXPECT_TRUE(seen.is_obstacle(kThere)) << lasts;
    time += lasts + 1;
    seen.obstacles.pass_time(time);
    EXPECT_FALSE(seen.is_obstacle(kThere)) << lasts;
  }
}

TEST(SeenObstacles, are_gone_with_all_patience_when_beams_go_on_beyond_them) {
  Seen seen;
  seen.look(kOneAhead, 1);
  seen.obstacles.pass_time(40);
  seen.look(kOneAhead, 41);  // for a minute
  seen.look(kNothing, 42);
  EXPECT_FALSE(seen.obstacles.any());
  seen.look(kOneAhead, 43);
  seen.obstacles.pass_time(74);
  EXPECT_FALSE(seen.obstacles.any());
}

TEST(SeenObstacles, stay_where_a_beam_that_crosses_them_ends_before_or_in_them_or_none_crosses_them) {
  RangeScan aside = kNothing;
  aside.first_angle += radians(6);
  for (const RangeScan& scan :
       {nine(0.5f), nine(1.05f), nine(0), nine(3, 1), ahead({3, 3}, radians(30)), aside}) {
    Seen seen;
    seen.look(kOneAhead, 1);
    seen.look(scan, 2);
    EXPECT_TRUE(seen.is_obstacle(kThere)) << scan.ranges[0] << " m, from " << scan.first_angle << " on";
  }
}

TEST(SeenObstacles, behind_the_robot_are_seen_by_a_scan_of_a_full_circle_alone) {
  RangeScan around{{{}}, std::vector<float>(180, 3), 0, radians(2)};
  around.max_range = 3;
  const Vec2 behind = kMiddle.xy() - Vec2{1, 0};
  for (const double first : {0.0, radians(-180), radians(-90), radians(540)}) {
    Seen seen;
    around.first_angle = first;
    RangeScan hit = around;
    for (std::size_t i = 0; i < 180; ++i)
      if (std::abs(geom::normalize(hit.angle(i) - geom::kPi)) < radians(1)) hit.ranges[i] = 1;
    seen.look(hit, 1);
    ASSERT_TRUE(seen.is_obstacle(behind)) << first;
    seen.look(kNothing, 2);
    EXPECT_TRUE(seen.is_obstacle(behind)) << first;
    seen.look(around, 3);
    EXPECT_FALSE(seen.is_obstacle(behind)) << first;
  }
}

TEST(SeenObstacles, of_a_ring_come_and_go_by_the_sensor_that_points_at_them) {
  Seen seen;
  RangeScan ring{ring_of({{0.1, 0, 0, 0}, {0, 0.1, 0, radians(90)}}), {0.9f, 3}};
  seen.look(ring, 1);
  EXPECT_TRUE(seen.is_obstacle(kThere));
  ring.ranges = {0.9f, 2.9f};
  seen.look(ring, 2);
  EXPECT_TRUE(seen.is_obstacle(kThere));
  ring.ranges = {2.9f, 2.9f};
  seen.look(ring, 3);
  EXPECT_FALSE(seen.is_obstacle(kThere));
}

TEST(SeenObstacles, are_all_forgotten_when_the_time_goes_back) {
  Seen seen;
  seen.look(kOneAhead, 50);
  seen.obstacles.pass_time(49);
  EXPECT_FALSE(seen.obstacles.any());
  EXPECT_EQ(seen.obstacles.costs().weights, seen.costs->weights);
}

TEST(SeenObstacles, are_so_many_at_most) {
  const GridMap map{{0.01f, 400, 400, {}}, std::vector<std::int8_t>(400 * 400, -1)};
  Seen seen(map, {.range = 100, .tolerance = 0}, {.safety_distance = 0});
  RangeScan scan{{{}}, {}, -1, 2.0 / 999};
  for (int row = 29; row >= 0; --row) {  // the nearer ones hide those behind
    scan.ranges.assign(1000, 1 + 0.05f * static_cast<float>(row));
    seen.look(scan, 1, {0.2, 2, 0, 0});
  }
  EXPECT_EQ(seen.obstacles.come() - seen.obstacles.gone(), SeenObstacles::kMostRemembered);
}

RC_GTEST_PROP(SeenObstacles, block_the_cells_that_they_would_block_on_the_map, ()) {
  GridMap map = open_floor();
  for (int wall = *rc::gen::inRange(0, 4); wall > 0; --wall)
    map.cells[*rc::gen::inRange<std::size_t>(0, map.cells.size())] = 1;
  const PlanOptions plan{*rc::gen::inRange(0, 12) / 16.0, 1, 1};
  Seen seen(map, {.range = 10, .lasts = 10}, plan);
  std::vector<CellIndex> cells;
  double time = 0;
  for (int scans = *rc::gen::inRange(1, 12); scans > 0; --scans) {
    RangeScan scan{{{}}, {}, *rc::gen::inRange(-314, 314) / 100.0, radians(*rc::gen::inRange(1, 10))};
    scan.max_range = 4;
    for (int beams = *rc::gen::inRange(1, 36); beams > 0; --beams)
      scan.ranges.push_back(static_cast<float>(*rc::gen::inRange(0, 45)) / 10);
    time += *rc::gen::inRange(0, 8);
    seen.look(scan, time, {*rc::gen::inRange(2, 48) / 10.0, *rc::gen::inRange(2, 48) / 10.0, 0, 0});
  }
  GridMap same = map;
  std::size_t obstacles = 0;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x)
      if (seen.obstacles.is_obstacle(seen.costs->cell(x + 1, y + 1))) {
        same.cells[static_cast<std::size_t>(40 * y + x)] = 1;
        ++obstacles;
      }
  RC_CLASSIFY(obstacles > 0, "some");
  RC_ASSERT(seen.obstacles.come() - seen.obstacles.gone() == obstacles);
  const CostMap expected = cost_map(same, plan);
  for (CellIndex cell = 0; cell < expected.count(); ++cell) {
    RC_ASSERT(seen.obstacles.costs().free(cell) == expected.free(cell));
    RC_ASSERT((seen.obstacles.costs().weights[cell] == CostMap::kObstacle) ==
              (expected.weights[cell] == CostMap::kObstacle));
    RC_ASSERT(!expected.free(cell) || seen.obstacles.costs().weights[cell] == seen.costs->weights[cell]);
  }
}

}  // namespace
}  // namespace playhouse::drivers
