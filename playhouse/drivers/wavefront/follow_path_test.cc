// A robot that follows its path in rooms where something is that its map lacks: what it sees by a ring of beams, and
// where it goes.

#include "playhouse/drivers/wavefront/follow_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace playhouse::drivers {
namespace {

using geom::Pose;
using geom::Vec2;
using ::testing::HasSubstr;

constexpr float kScale = 0.125f;  // m per cell
constexpr double kTick = 0.1, kSpeed = 1;

/// The place of a rectangle of cells. [m]
struct Box {
  double x0, y0, x1, y1;
};

void fill(GridMap& map, const Box& box, std::int8_t value) {
  for (auto y = static_cast<int>(box.y0 / kScale); y < static_cast<int>(box.y1 / kScale); ++y)
    for (auto x = static_cast<int>(box.x0 / kScale); x < static_cast<int>(box.x1 / kScale); ++x)
      map.cells[static_cast<std::size_t>(y * map.width() + x)] = value;
}

constexpr Box kDoor{5, 1, 5.25, 2}, kFarDoor{5, 8, 5.25, 9.5};
constexpr Box kCrate{4.5, 1, 5, 2};  // right before the door
constexpr Pose kStart{2, 1.5, 0, 0}, kGoal{8, 1.5, 0, 0};

/// 10 x 10 m, two rooms with doors between them.
GridMap rooms(bool has_far_door = true) {
  GridMap map{{kScale, 80, 80, {}}, std::vector<std::int8_t>(80 * 80, -1)};
  fill(map, {5, 0, 5.25, 10}, 1);
  fill(map, kDoor, -1);
  if (has_far_door) fill(map, kFarDoor, -1);
  return map;
}

GridMap with(GridMap map, const Box& box) {
  fill(map, box, 1);
  return map;
}

class Walk {
 public:
  explicit Walk(const GridMap& map, bool has_eyes = true) : truth(map), has_eyes(has_eyes) {
    in.map = std::make_shared<const GridMap>(map);
    in.X_WR = kStart;
    go_to(kGoal);
  }

  void go_to(const Pose& X_WT) {
    ++in.goal;
    in.X_WT = X_WT;
  }
  bool stands_free(Vec2 p_W) const {
    const double column = std::floor(p_W.x / kScale), row = std::floor(p_W.y / kScale);
    if (!(column >= 0 && row >= 0 && column < truth.width() && row < truth.height())) return false;
    const int x = static_cast<int>(column), y = static_cast<int>(row);
    return truth.cells[static_cast<std::size_t>(y * truth.width() + x)] < 0;
  }
  float range(double angle) const {
    const Vec2 along = geom::Rotation::of(angle) * Vec2{1, 0};
    for (double range = 0; range < kMostRange; range += kScale / 8)
      if (!stands_free(in.X_WR.xy() + range * along)) return static_cast<float>(range);
    return kMostRange;
  }
  PlacedScan scan() const {
    PlacedScan seen{{{{}}, {}, -geom::kPi, 2 * geom::kPi / 360}, compose(in.X_WR, pose_error)};
    for (std::size_t i = 0; i < 360; ++i) seen.scan.ranges.push_back(range(in.X_WR.a + seen.scan.angle(i)));
    seen.scan.max_range = kMostRange;
    return seen;
  }
  const FollowOut& step() {
    in.time += kTick;
    if (has_eyes) in.seen = scan();
    in.X_OR = in.X_WR;
    out = follow_path(options, in, memory);
    in.seen.reset();
    if (out.X_OP) told = *out.X_OP;
    if (out.route == nullptr) return out;
    const Vec2 way = told.xy() - in.X_WR.xy();
    const double left = std::sqrt(dot(way, way));
    if (left < kSpeed * kTick) {
      in.X_WR = told;
    } else if (const Vec2 next = in.X_WR.xy() + kSpeed * kTick / left * way; stands_free(next)) {
      in.X_WR = {next.x, next.y, 0, geom::atan2(way.y, way.x)};
    }
    highest = std::max(highest, in.X_WR.y);
    return out;
  }
  /// True if it arrived by then.
  bool walk(double seconds) {
    for (double end = in.time + seconds; in.time < end && !out.done();) step();
    return out.done();
  }
  double length() const { return out.route == nullptr ? -1 : out.route->length; }

  static constexpr float kMostRange = 8;
  WavefrontOptions options;
  FollowIn in;
  FollowMemory memory;
  FollowOut out;
  GridMap truth;
  bool has_eyes;
  Pose told, pose_error;
  double highest = 0;  // where it was. [m]
};

TEST(FollowPath, a_crate_in_a_door_that_its_map_lacks_holds_it_up_for_ever_unless_it_sees_it) {
  Walk blind(rooms(), false), seeing(rooms());
  blind.truth = seeing.truth = with(rooms(), kCrate);
  EXPECT_FALSE(blind.walk(100));
  EXPECT_LT(blind.in.X_WR.x, 4.6);
  EXPECT_TRUE(seeing.walk(30));
  EXPECT_GT(seeing.highest, 8);
}

TEST(FollowPath, with_nothing_new_to_see_it_goes_as_without_eyes) {
  Walk blind(rooms(), false), seeing(rooms());
  for (int tick = 0; tick < 100; ++tick) {
    blind.step();
    seeing.step();
    ASSERT_EQ(blind.in.X_WR, seeing.in.X_WR) << tick;
  }
  EXPECT_TRUE(seeing.out.done());
}

TEST(FollowPath, walls_seen_beside_their_places_are_those_of_the_map) {
  Walk walk(rooms());
  walk.pose_error = {0.07, -0.07, 0, geom::radians(1)};
  EXPECT_TRUE(walk.walk(10));
  EXPECT_EQ(walk.memory.seen->come(), 0u);
  Walk careful(rooms());
  careful.options.sight.tolerance = 0.01;
  careful.pose_error = walk.pose_error;
  careful.step();
  EXPECT_GT(careful.memory.seen->come(), 0u) << "or the pose is not wrong enough";
}

TEST(FollowPath, plans_round_what_comes_into_its_way_at_once) {
  Walk walk(rooms());
  walk.step();
  EXPECT_LT(walk.length(), 7);
  for (int tick = 0; tick < 10; ++tick) walk.step();
  walk.truth = with(rooms(), kCrate);
  walk.step();
  EXPECT_GT(walk.length(), 12);
}

TEST(FollowPath, something_beside_its_way_changes_nothing) {
  Walk walk(rooms());
  walk.truth = with(rooms(), {3, 4, 4, 5});
  walk.step();
  const Route* const route = walk.out.route.get();
  for (int tick = 0; tick < 10; ++tick) walk.step();
  EXPECT_GT(walk.memory.seen->come(), 0u);
  EXPECT_EQ(walk.out.route.get(), route);
}

TEST(FollowPath, takes_the_short_way_again_once_it_sees_that_it_is_free) {
  Walk walk(rooms());
  walk.truth = with(rooms(), kCrate);
  for (int tick = 0; tick < 10; ++tick) walk.step();
  EXPECT_GT(walk.length(), 12);
  walk.truth = rooms();
  EXPECT_TRUE(walk.walk(15));
  EXPECT_LT(walk.highest, 6);
}

TEST(FollowPath, takes_the_short_way_again_once_it_has_not_seen_the_crate_for_its_time) {
  Walk walk(rooms());
  walk.truth = with(rooms(), kCrate);
  walk.in.enabled = false;
  walk.step();
  walk.has_eyes = false;
  walk.in.time += walk.options.sight.lasts - 2 * kTick;
  walk.step();
  EXPECT_GT(walk.length(), 12);
  walk.step();
  walk.step();
  EXPECT_LT(walk.length(), 7);
}

TEST(FollowPath, what_stays_does_not_let_it_go_to_and_fro_for_ever) {
  Walk walk(rooms());
  walk.options.sight.lasts = 1;  // it is forgotten long before the other door
  walk.options.sight.range = 1.5;
  walk.truth = with(rooms(), kCrate);
  EXPECT_TRUE(walk.walk(120));
}

TEST(FollowPath, where_there_is_no_other_way_it_waits_until_the_crate_has_gone) {
  const GridMap one_door = rooms(false);
  Walk walk(one_door);
  walk.truth = with(one_door, kCrate);
  walk.step();
  EXPECT_EQ(walk.out.route, nullptr);
  EXPECT_EQ(walk.out.fault, "something that is not on the map is in the way");
  EXPECT_TRUE(walk.out.may_pass) << "a person, maybe";
  walk.walk(walk.options.sight.lasts - 1);
  EXPECT_TRUE(walk.out.may_pass);
  walk.walk(2);
  EXPECT_FALSE(walk.out.may_pass);
  EXPECT_EQ(walk.out.route, nullptr);
  walk.truth = one_door;
  walk.walk(1);
  EXPECT_NE(walk.out.route, nullptr);
  EXPECT_EQ(walk.out.fault, "");
  EXPECT_FALSE(walk.out.may_pass);
  EXPECT_TRUE(walk.walk(10));
}

TEST(FollowPath, a_goal_where_something_stands_is_waited_for_too) {
  Walk walk(rooms());
  walk.truth = with(rooms(), {7.75, 1.25, 8.25, 1.75});
  EXPECT_FALSE(walk.walk(10));
  EXPECT_THAT(walk.out.fault, HasSubstr("not on the map"));
  EXPECT_LT(walk.in.X_WR.x, 7.5);
  walk.truth = rooms();
  EXPECT_TRUE(walk.walk(10));
}

TEST(FollowPath, a_goal_that_the_map_refuses_has_the_reason_of_the_map) {
  Walk walk(rooms());
  walk.truth = with(rooms(), kCrate);
  walk.go_to({5.1, 5, 0, 0});
  walk.step();
  EXPECT_EQ(walk.out.fault, "the goal is within safety_dist of an obstacle");
  EXPECT_FALSE(walk.out.may_pass);
}

TEST(FollowPath, somebody_who_crosses_its_way_again_and_again_does_not_keep_it_from_arriving) {
  const GridMap one_door = rooms(false);
  Walk walk(one_door);
  for (int tick = 0; tick < 600 && !walk.out.done(); ++tick) {
    const double y = 1 + 0.125 * (tick % 16);  // along the wall before the door, every 1.6 s
    const Box person{4, y, 4.375, y + 0.375};
    walk.truth = one_door;
    if (std::abs(walk.in.X_WR.x - 4.2) > 0.7) walk.truth = with(one_door, person);
    walk.step();
  }
  EXPECT_TRUE(walk.out.done());
}

TEST(FollowPath, carried_off_the_map_it_looks_along_no_way) {
  Walk walk(rooms());
  walk.options.replan_distance = 0;
  walk.step();
  const Route* const route = walk.out.route.get();
  for (int tick = 0; tick < 10; ++tick) {
    walk.in.seen = walk.scan();
    walk.in.seen->scan.ranges.assign(360, 1);
    walk.has_eyes = false;
    walk.step();
    walk.in.X_WR = {1e9, -1e9, 0, 0};
  }
  EXPECT_GT(walk.memory.seen->come(), 0u);
  EXPECT_EQ(walk.out.route.get(), route);
}

TEST(FollowPath, another_map_begins_without_what_was_seen_on_the_old_one) {
  Walk walk(rooms());
  walk.truth = with(rooms(), kCrate);
  walk.step();
  EXPECT_GT(walk.length(), 12);
  walk.has_eyes = false;
  walk.in.map = std::make_shared<const GridMap>(rooms());
  ++walk.in.goal;
  walk.step();
  EXPECT_LT(walk.length(), 7);
}

}  // namespace
}  // namespace playhouse::drivers
