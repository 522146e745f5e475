// Steps of nearness diagram navigation on scans of drawn places, and a body that drives by them.

#include "playhouse/drivers/nd/nd_step.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <span>

#include "playhouse/drivers/nd/nd_diagram.h"

namespace playhouse::drivers {
namespace {

using geom::radians;
using geom::Vec2;
using Situation = NdSituation;

struct Disc {
  Vec2 p_OD;
  double radius;
};

using Discs = std::vector<Disc>;

/// Distance along a ray to the first disc, 8 m at most.
double range(const Discs& discs, Vec2 p, double angle) {
  const Vec2 ahead{std::cos(angle), std::sin(angle)};
  double nearest = 8;
  for (const Disc& disc : discs) {
    const Vec2 to = disc.p_OD - p;
    const double along = dot(to, ahead),
                 inside = disc.radius * disc.radius - cross(ahead, to) * cross(ahead, to);
    if (inside >= 0 && along > 0) nearest = std::min(nearest, along - std::sqrt(inside));
  }
  return std::max(0.0, nearest);
}

/// A wall along y, of discs that overlap.
void add_wall(Discs& discs, double x, double from, double to) {
  for (double y = from; y < to; y += 0.05) discs.push_back({{x, y}, 0.05});
  discs.push_back({{x, to}, 0.05});
}

const NdRobot kRobot{{-0.25, -0.2, 0.25, 0.2}};

/// A scanner in the middle of the robot that sees nothing yet.
RangeScan scanner(double first_angle, std::vector<float> ranges = {}) {
  return {{ScanEye{}}, std::move(ranges), first_angle, radians(1), 8};
}

/// What a scanner of 181 beams, ahead and to both sides, shows of discs.
NdIn seen(const Discs& discs, const geom::Pose& X_OR, const geom::Pose& X_OG) {
  NdIn in;
  in.X_OR = X_OR;
  in.X_OG = X_OG;
  RangeScan& scan = *in.scans.emplace_back(scanner(radians(-90)));
  for (int beam = 0; beam < 181; ++beam) {
    const double angle = X_OR.a + scan.first_angle + beam * scan.angle_step;
    scan.ranges.push_back(static_cast<float>(range(discs, X_OR.xy(), angle)));
  }
  return in;
}

NdOut step(const NdIn& in, const NdOptions& options = {}, const NdRobot& robot = kRobot) {
  NdMemory memory;
  return nd_step(options, robot, in, memory);
}

/// Clearance of a body from discs.
double clearance_of(const geom::Box& body, const geom::Pose& X_OR, const Discs& discs) {
  double least = 8;
  for (const Disc& disc : discs)
    least = std::min(least, clearance(body, geom::transform(geom::inverse(X_OR), disc.p_OD)) - disc.radius);
  return least;
}

struct Drive {
  std::vector<geom::Pose> path;
  std::set<Situation> situations;
  double clearance = 8;
  bool done = false, stuck = false;
};

/// Drives to a goal for two minutes at most, with a scan each 0.1 s.
Drive drive(const Discs& discs, const geom::Pose& X_OG, const NdOptions& options) {
  Drive drive;
  NdMemory memory;
  geom::Pose X_OR;
  for (int tick = 0; tick < 1200 && !drive.done && !drive.stuck; ++tick) {
    NdIn in = seen(discs, X_OR, X_OG);
    in.time = 0.1 * tick;
    const NdOut out = nd_step(options, kRobot, in, memory);
    X_OR = geom::compose(X_OR, {0.1 * out.speed, 0, 0, 0.1 * out.turn_rate});
    drive.path.push_back(X_OR);
    drive.situations.insert(out.situation);
    drive.clearance = std::min(drive.clearance, clearance_of(kRobot.body, X_OR, discs));
    drive.done = out.done;
    drive.stuck = out.stuck;
  }
  return drive;
}

TEST(NdStep, drives_straight_to_a_goal_ahead_when_nothing_is_in_the_way) {
  const NdOut out = step(seen({}, {}, {5, 0, 0, 0}));
  EXPECT_DOUBLE_EQ(out.speed, 0.3);
  EXPECT_NEAR(out.turn_rate, 0, 1e-12);
  EXPECT_EQ(out.situation, Situation::kHighSafetyGoalInRegion);
  EXPECT_FALSE(out.done);
}

TEST(NdStep, is_as_fast_as_it_may_where_there_is_nothing) {
  NdOptions fast;
  fast.max_speed = 2;
  fast.avoid_distance = 6;  // farther than it sees
  EXPECT_DOUBLE_EQ(step(seen({}, {}, {50, 0, 0, 0}), fast).speed, 2);
}

TEST(NdStep, turns_to_the_side_of_the_goal) {
  EXPECT_GT(step(seen({}, {}, {3, 3, 0, 0})).turn_rate, 0);
  EXPECT_LT(step(seen({}, {}, {3, -3, 0, 0})).turn_rate, 0);
  const NdOut behind = step(seen({}, {}, {-3, 1, 0, 0}));
  EXPECT_EQ(behind.speed, 0);
  EXPECT_DOUBLE_EQ(behind.turn_rate, radians(45));
}

TEST(NdStep, before_a_wall_it_drives_for_the_end_nearer_to_its_goal) {
  Discs left_longer, right_longer;
  add_wall(left_longer, 2, -0.5, 1.2);
  add_wall(right_longer, 2, -1.2, 0.5);
  const NdOut right = step(seen(left_longer, {}, {4, 0, 0, 0}));
  EXPECT_LT(right.turn_rate, -radians(10));
  EXPECT_EQ(right.situation, Situation::kHighSafetyWideRegion);
  EXPECT_GT(step(seen(right_longer, {}, {4, 0, 0, 0})).turn_rate, radians(10));
}

TEST(NdStep, keeps_to_the_side_that_it_chose_when_the_other_is_only_a_little_nearer) {
  Discs wall;
  add_wall(wall, 2, -0.8, 0.9);
  const NdIn in = seen(wall, {}, {4, 0, 0, 0});
  NdMemory memory;
  EXPECT_LT(nd_step({}, kRobot, in, memory).turn_rate, -radians(10));
  memory.direction = radians(40);
  EXPECT_GT(nd_step({}, kRobot, in, memory).turn_rate, radians(10));
}

TEST(NdStep, keeps_the_sense_of_its_turn_to_a_goal_behind_it) {
  const NdIn in = seen({}, {}, {-3, 0.1, 0, 0});
  NdMemory memory;
  memory.turn_rate = -0.5;
  EXPECT_DOUBLE_EQ(nd_step({}, kRobot, in, memory).turn_rate, -radians(45));
  memory.turn_rate = 0;
  EXPECT_DOUBLE_EQ(nd_step({}, kRobot, in, memory).turn_rate, radians(45));
}

TEST(NdStep, a_narrow_region_is_driven_for_in_its_middle) {
  Discs wall;
  add_wall(wall, 2, -6, 0.2);
  add_wall(wall, 2, 1.2, 6);
  const NdOut out = step(seen(wall, {}, {6, -1, 0, 0}));
  EXPECT_EQ(out.situation, Situation::kHighSafetyNarrowRegion);
  EXPECT_NEAR(out.turn_rate, geom::atan2(0.7, 2), radians(3)) << "full rate is for 45 degrees";
}

TEST(NdStep, goes_round_a_wall_and_touches_nothing) {
  Discs wall;
  add_wall(wall, 2, -1, 1.5);
  const Drive driven = drive(wall, {4, 0, 0, 0}, {});
  EXPECT_TRUE(driven.done);
  EXPECT_GT(driven.clearance, 0.1);
}

TEST(NdStep, passes_a_gap_of_a_metre_in_its_middle) {
  Discs wall;
  add_wall(wall, 2, -5, 0.3);
  add_wall(wall, 2, 1.3, 5);
  const Drive driven = drive(wall, {4, 0, 0, 0}, {});
  EXPECT_TRUE(driven.done);
  EXPECT_GT(driven.clearance, 0.1);
  EXPECT_TRUE(driven.situations.contains(Situation::kLowSafetyBothSides));
  for (const geom::Pose& X_OR : driven.path)
    if (std::abs(X_OR.x - 2) < 0.05) EXPECT_NEAR(X_OR.y, 0.8, 0.1);
}

TEST(NdStep, does_not_try_a_gap_that_is_too_narrow) {
  Discs wall;
  add_wall(wall, 2, -1.5, -0.15);
  add_wall(wall, 2, 0.15, 1.5);
  EXPECT_GT(std::abs(step(seen(wall, {}, {4, 0, 0, 0})).turn_rate), radians(20)) << "to one of the ends";
  Discs wider;
  add_wall(wider, 2, -1.5, -0.4);
  add_wall(wider, 2, 0.4, 1.5);
  EXPECT_NEAR(step(seen(wider, {}, {4, 0, 0, 0})).turn_rate, 0, radians(2));
}

TEST(NdStep, veers_away_from_what_is_near_on_one_side_and_slows_down) {
  const NdOut left = step(seen({{{0.5, 0.35}, 0.1}}, {}, {5, 0, 0, 0}));
  EXPECT_EQ(left.situation, Situation::kLowSafetyOneSide);
  EXPECT_LT(left.turn_rate, -radians(10));
  EXPECT_LT(left.speed, 0.25);
  const NdOut right = step(seen({{{0.5, -0.35}, 0.1}}, {}, {5, 0, 0, 0}));
  EXPECT_GT(right.turn_rate, radians(10));
}

TEST(NdStep, keeps_to_the_middle_between_what_is_near_on_both_sides) {
  const NdOut middle = step(seen({{{0.5, 0.5}, 0.1}, {{0.5, -0.5}, 0.1}}, {}, {5, 0, 0, 0}));
  EXPECT_EQ(middle.situation, Situation::kLowSafetyBothSides);
  EXPECT_NEAR(middle.turn_rate, 0, radians(1));
  EXPECT_LT(middle.speed, 0.25);
  EXPECT_LT(step(seen({{{0.5, 0.4}, 0.1}, {{0.5, -0.6}, 0.1}}, {}, {5, 0, 0, 0})).turn_rate, -radians(3));
}

TEST(NdStep, a_larger_avoid_dist_avoids_earlier) {
  NdOptions options;
  const NdIn in = seen({{{0.9, 0.6}, 0.1}}, {}, {5, 0, 0, 0});
  EXPECT_EQ(step(in, options).situation, Situation::kHighSafetyGoalInRegion);
  options.avoid_distance = 1;
  EXPECT_EQ(step(in, options).situation, Situation::kLowSafetyOneSide);
}

TEST(NdStep, safety_dist_makes_a_gap_too_narrow) {
  Discs wall;
  add_wall(wall, 2, -1.5, -0.4);
  add_wall(wall, 2, 0.4, 1.5);
  NdOptions options;
  options.safety_distance = 0.2;
  EXPECT_GT(std::abs(step(seen(wall, {}, {4, 0, 0, 0}), options).turn_rate), radians(20));
}

TEST(NdStep, a_goal_in_front_of_an_obstacle_is_free) {
  Discs wall;
  add_wall(wall, 2, -1, 1);
  EXPECT_NEAR(step(seen(wall, {}, {1.6, 0, 0, 0})).turn_rate, 0, radians(1));
  EXPECT_GT(std::abs(step(seen(wall, {}, {2.8, 0, 0, 0})).turn_rate), radians(10)) << "one behind it is not";
}

TEST(NdStep, what_is_beyond_the_goal_is_not_avoided) {
  Discs wall;
  add_wall(wall, 1, -1, 1);
  NdOptions options;
  options.goal_distance = 0.1;
  EXPECT_EQ(step(seen(wall, {0.4, 0, 0, 0}, {0.6, 0, 0, 0}), options).situation,
            Situation::kHighSafetyGoalInRegion);
}

TEST(NdStep, drives_no_faster_than_it_could_stop_before_a_touch) {
  NdOptions options;
  options.max_speed = 1;
  options.avoid_distance = 0.001;  // or it would veer away
  const NdOut out = step(seen({{{0.7, 0.22}, 0.03}}, {}, {5, 0, 0, 0}), options);
  EXPECT_NEAR(out.turn_rate, 0, 1e-12);
  const double room = 0.7 - 0.03 - kRobot.body.x_max;
  EXPECT_LT(out.speed * (0.4 + out.speed), room + 0.05);
  EXPECT_GT(out.speed, 0.2);
}

/// An all-round scan of the same range everywhere.
NdIn ring(float radius, const geom::Pose& X_OG) {
  NdIn in;
  in.X_OG = X_OG;
  in.scans = {scanner(radians(-180), std::vector<float>(360, radius))};
  return in;
}

TEST(NdStep, where_all_directions_are_blocked_it_stops_and_turns_to_the_goal) {
  const NdOut left = step(ring(1, {0, 3, 0, 0}));
  EXPECT_EQ(left.situation, Situation::kBlocked);
  EXPECT_EQ(left.speed, 0);
  EXPECT_DOUBLE_EQ(left.turn_rate, radians(45));
  EXPECT_DOUBLE_EQ(step(ring(1, {0, -3, 0, 0})).turn_rate, -radians(45));
}

TEST(NdStep, does_not_turn_its_tail_into_a_wall) {
  const NdRobot robot{{-0.8, -0.2, 0.2, 0.2}};
  Discs beside;
  for (double x = -1.5; x < 1.5; x += 0.05) beside.push_back({{x, -0.45}, 0.05});
  NdIn in = seen({}, {}, {-1, 3, 0, 0});
  in.scans = {scanner(radians(-180))};
  for (int beam = 0; beam < 360; ++beam)
    in.scans[0]->ranges.push_back(static_cast<float>(range(beside, {}, radians(beam - 180))));
  const NdOut out = step(in, {}, robot);
  EXPECT_EQ(out.turn_rate, 0) << "the tail would swing to the right";
  EXPECT_DOUBLE_EQ(out.speed, 0.05) << "it drives to where it has room";
  EXPECT_DOUBLE_EQ(step(in).turn_rate, radians(45)) << "a shorter one can turn";
}

TEST(NdStep, at_the_goal_it_turns_to_the_heading_and_is_done) {
  const NdOut turning = step(seen({}, {0.3, 0, 0, 0}, {0, 0, 0, radians(-90)}));
  EXPECT_EQ(turning.speed, 0);
  EXPECT_DOUBLE_EQ(turning.turn_rate, -radians(45));
  const NdOut nearly = step(seen({}, {0.3, 0, 0, 0}, {0, 0, 0, radians(10.5)}));
  EXPECT_NEAR(nearly.turn_rate, radians(10.5), 1e-9);
  NdOptions slow;
  slow.min_turn_rate = radians(20);
  const NdIn in = seen({}, {0.3, 0, 0, 0}, {0, 0, 0, radians(10.5)});
  EXPECT_DOUBLE_EQ(step(in, slow).turn_rate, radians(20)) << "no slower than a motor can";
  const NdOut there = step(seen({}, {0.3, 0, 0, 0}, {0, 0, 0, radians(9)}));
  EXPECT_TRUE(there.done);
  EXPECT_EQ(there.turn_rate, 0);
}

TEST(NdStep, keeps_the_sense_of_its_turn_at_the_goal) {
  NdMemory memory;
  memory.turn_rate = -0.5;  // of the drive, which does not count
  EXPECT_DOUBLE_EQ(nd_step({}, kRobot, seen({}, {}, {0, 0, 0, radians(175)}), memory).turn_rate, radians(45));
  EXPECT_DOUBLE_EQ(nd_step({}, kRobot, seen({}, {}, {0, 0, 0, radians(-175)}), memory).turn_rate,
                   radians(45));
}

/// Time of the first step that is stuck, with steps each 0.1 s of a robot at `pose(time)`; 10 if none is.
template <typename PoseAt>
double stuck_at(const NdOptions& options, const geom::Pose& X_OG, PoseAt pose) {
  NdMemory memory;
  for (int tick = 0; tick < 100; ++tick) {
    NdIn in = seen({}, pose(0.1 * tick), X_OG);
    in.time = 0.1 * tick;
    if (nd_step(options, kRobot, in, memory).stuck) return in.time;
  }
  return 10;
}

TEST(NdStep, is_stuck_when_it_has_neither_driven_nor_turned_for_a_time) {
  const auto drives = [](double speed) {
    return [=](double time) { return geom::Pose{speed * time, 0, 0, 0}; };
  };
  const auto turns = [](double rate) {
    return [=](double time) { return geom::Pose{0, 0, 0, rate * time}; };
  };
  const geom::Pose X_OG{5, 0, 0, 0};
  NdOptions options;
  EXPECT_NEAR(stuck_at(options, X_OG, drives(0)), 2.1, 1e-9);
  EXPECT_EQ(stuck_at(options, X_OG, drives(0.13)), 10) << "0.26 m in 2 s";
  EXPECT_NEAR(stuck_at(options, X_OG, drives(0.11)), 2.1, 1e-9);
  EXPECT_EQ(stuck_at(options, X_OG, turns(radians(11))), 10) << "22 degrees in 2 s";
  EXPECT_NEAR(stuck_at(options, X_OG, turns(radians(9))), 2.1, 1e-9);
  options.translate_stuck_time = 5;
  EXPECT_NEAR(stuck_at(options, X_OG, drives(0)), 5.1, 1e-9);
  options.translate_stuck_distance = 0.6;
  EXPECT_NEAR(stuck_at(options, X_OG, drives(0.11)), 5.1, 1e-9);
}

TEST(NdStep, is_stuck_when_its_turn_to_the_goal_s_heading_does_not_get_on) {
  const geom::Pose X_OG{0, 0, 0, radians(90)};
  NdOptions options;
  options.rotate_stuck_time = 3;
  EXPECT_NEAR(stuck_at(options, X_OG, [](double) { return geom::Pose{}; }), 3.1, 1e-9);
  EXPECT_EQ(stuck_at(options, X_OG, [](double time) { return geom::Pose{0, 0, 0, radians(5) * time}; }), 10);
  EXPECT_NEAR(stuck_at(options, X_OG,
                       [](double time) {
                         return geom::Pose{0, 0, 0, radians(-5) * time};
                       }),
              3.1, 1e-9);
}

TEST(NdStep, waits_for_the_end_of_a_stall_only_if_told_to) {
  NdOptions options;
  NdIn in = seen({}, {}, {5, 0, 0, 0});
  in.stall = true;
  EXPECT_GT(step(in, options).speed, 0);
  options.wait_on_stall = true;
  NdMemory memory;
  for (int tick = 0; tick < 50; ++tick) {
    in.time = 0.1 * tick;
    in.stall = tick >= 10 && tick < 40;
    const NdOut out = nd_step(options, kRobot, in, memory);
    EXPECT_FALSE(out.stuck) << in.time << " s; of them 3 s were waited";
    EXPECT_EQ(out.speed, in.stall ? 0 : 0.3);
  }
  in.time = 5.2;
  EXPECT_TRUE(nd_step(options, kRobot, in, memory).stuck);
}

TEST(NdStep, keeps_the_points_of_the_last_scans_where_they_were_seen) {
  NdOptions options;
  options.laser_buffer = 3;
  const Discs disc = {{{0.5, 0.35}, 0.1}};
  NdMemory memory;
  nd_step(options, kRobot, seen(disc, {}, {5, 0, 0, 0}), memory);
  const geom::Pose X_OR{0.02, 0, 0, 0.05};
  for (int scan = 1; scan < 3; ++scan)
    EXPECT_EQ(nd_step(options, kRobot, seen({}, X_OR, {5, 0, 0, 0}), memory).situation,
              Situation::kLowSafetyOneSide);
  EXPECT_EQ(nd_step(options, kRobot, seen({}, X_OR, {5, 0, 0, 0}), memory).situation,
            Situation::kHighSafetyGoalInRegion);
}

TEST(NdStep, sonars_alone_show_it_the_way_and_bad_ones_are_left_out) {
  NdIn in;
  in.X_OG = {5, 0, 0, 0};
  in.scans = {RangeScan{ring_of({{0.2, 0, 0, 0}, {0.2, 0.1, 0, radians(30)}, {0.2, -0.1, 0, radians(-30)}}),
                        {5, 0.3f, 5}}};
  NdOptions options;
  const NdOut out = step(in, options);
  EXPECT_EQ(out.situation, Situation::kLowSafetyOneSide);
  EXPECT_LT(out.turn_rate, 0);
  options.bad_sonars = {1};
  EXPECT_EQ(step(in, options).situation, Situation::kHighSafetyGoalInRegion);
}

TEST(NdStep, the_laser_s_place_on_the_robot_counts) {
  NdIn in = seen({{{0.6, 0}, 0.1}}, {}, {5, 0, 0, 0});
  in.scans[0]->eyes[0].X_RS = {0, 0, 0, radians(90)};
  EXPECT_LT(step(in).turn_rate + radians(1), 0) << "what is ahead of the scanner is on the left";
}

TEST(NdStep, a_scan_that_cannot_be_used_stops_it) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  NdIn in = seen({}, {}, {5, 0, 0, 0});
  for (const double step_width : {0.0, -1.0, nan, 1e300}) {
    in.scans[0]->angle_step = step_width;
    EXPECT_EQ(step(in).speed, 0);
    EXPECT_EQ(step(in).situation, Situation::kWaiting);
  }
  in = seen({}, {}, {5, 0, 0, 0});
  for (const double range : {nan, -1.0}) {
    in.scans[0]->ranges[3] = static_cast<float>(range);
    EXPECT_EQ(step(in).speed, 0);
  }
  in.scans[0]->ranges.clear();
  EXPECT_EQ(step(in).speed, 0);
  in.scans = {RangeScan{ring_of({{}}), {static_cast<float>(nan)}}};
  EXPECT_EQ(step(in).speed, 0);
}

TEST(NdStep, a_scanner_of_short_range_sees_nothing_beyond_it) {
  NdIn in = seen({}, {}, {4, 0, 0, 0});
  in.scans[0]->max_range = 0.5;
  for (float& range : in.scans[0]->ranges) range = 0.5f;
  EXPECT_DOUBLE_EQ(step(in).speed, 0.3);
}

RC_GTEST_PROP(NdStep, keeps_its_limits_and_does_not_touch_what_it_sees, ()) {
  const auto number = [](double from, double to) {
    return from + (to - from) * static_cast<double>(*rc::gen::inRange(0, 1001)) / 1000;
  };
  Discs discs;
  for (int i = *rc::gen::inRange(0, 8); i > 0; --i)
    discs.push_back({{number(0, 2), number(-2, 2)}, number(0.05, 0.5)});
  const NdIn in = seen(discs, {}, {number(-5, 5), number(-5, 5), 0, number(-3, 3)});
  const NdOptions options;
  const NdOut out = step(in, options);
  RC_ASSERT(out.speed >= 0 && out.speed <= options.max_speed);
  RC_ASSERT(std::abs(out.turn_rate) <= options.max_turn_rate);
  const double now = clearance_of(kRobot.body, {}, discs);
  if (now < 0.04) return;
  geom::Pose X_OR;
  for (int part = 0; part < 3; ++part)  // 0.3 s: three scans
    X_OR = geom::compose(X_OR, {0.1 * out.speed, 0, 0, 0.1 * out.turn_rate});
  RC_ASSERT(clearance_of(kRobot.body, X_OR, discs) > 0);
}

TEST(NdStep, gives_the_same_bits_again) {
  const Discs discs = {{{1, -0.2}, 0.3}, {{2, 1}, 0.4}};
  NdMemory one, other;
  for (int tick = 0; tick < 50; ++tick) {
    NdIn in = seen(discs, {0.01 * tick, 0, 0, 0.005 * tick}, {4, 0.5, 0, 0});
    in.time = 0.1 * tick;
    const NdOut first = nd_step({}, kRobot, in, one), second = nd_step({}, kRobot, in, other);
    ASSERT_EQ(first.speed, second.speed);
    ASSERT_EQ(first.turn_rate, second.turn_rate);
  }
}

TEST(NdStep, a_robot_gets_to_its_goal_between_discs_and_touches_none) {
  const Discs discs = {{{1.5, 0.1}, 0.3}, {{3, -0.8}, 0.4}, {{3, 1.6}, 0.4}, {{4.5, 0.3}, 0.3}};
  const geom::Pose X_OG{6, 0, 0, radians(90)};
  NdOptions options;
  options.goal_distance = 0.1;
  const Drive driven = drive(discs, X_OG, options);
  EXPECT_TRUE(driven.done);
  EXPECT_NEAR(driven.path.back().x, 6, 0.1);
  EXPECT_NEAR(driven.path.back().y, 0, 0.1);
  EXPECT_NEAR(geom::normalize(driven.path.back().a - X_OG.a), 0, radians(10));
  EXPECT_GT(driven.clearance, 0.1);
}

}  // namespace
}  // namespace playhouse::drivers
