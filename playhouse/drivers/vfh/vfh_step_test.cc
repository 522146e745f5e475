// Steps of VFH+ on scans of drawn places, and a disc that drives by them.

#include "playhouse/drivers/vfh/vfh_step.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <span>

namespace playhouse::drivers {
namespace {

using geom::radians;
using geom::Vec2;

struct Disc {
  Vec2 p_OD;
  double radius;
};

using Discs = std::span<const Disc>;

/// Distance along a ray to the first disc, 8 m at most.
double range(Discs discs, Vec2 p, double angle) {
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

constexpr VfhRobot kRobot{0.25};

/// What a scanner of 181 beams, ahead and to both sides, shows of discs.
VfhIn seen(Discs discs, const geom::Pose& X_OR, const geom::Pose& X_OG) {
  VfhIn in;
  in.X_OR = X_OR;
  in.X_OG = X_OG;
  in.scan.eyes.resize(1);
  in.scan.max_range = 8;
  in.scan.first_angle = radians(-90);
  in.scan.angle_step = radians(1);
  for (int beam = 0; beam < 181; ++beam)
    in.scan.ranges.push_back(static_cast<float>(
        range(discs, X_OR.xy(), X_OR.a + in.scan.first_angle + beam * in.scan.angle_step)));
  return in;
}

/// A step of a robot that is under way: it has had a second to accelerate.
VfhOut step(const VfhIn& in, const VfhOptions& options = {}) {
  VfhMemory memory;
  memory.time = in.time - 1;
  memory.speed = options.max_speed;
  return vfh_step(options, kRobot, in, memory);
}

TEST(VfhStep, drives_straight_to_a_goal_ahead_when_nothing_is_in_the_way) {
  const VfhOut out = step(seen({}, {}, {5, 0, 0, 0}));
  EXPECT_DOUBLE_EQ(out.speed, 0.2);
  EXPECT_NEAR(out.turn_rate, 0, 1e-12);
  EXPECT_FALSE(out.done);
}

TEST(VfhStep, turns_to_the_side_of_the_goal) {
  EXPECT_GT(step(seen({}, {}, {3, 3, 0, 0})).turn_rate, 0);
  EXPECT_LT(step(seen({}, {}, {3, -3, 0, 0})).turn_rate, 0);
  EXPECT_GT(step(seen({}, {}, {-3, 1, 0, 0})).turn_rate, 0) << "also to one behind, which it does not see";
}

TEST(VfhStep, goes_round_a_disc_by_the_side_where_there_is_room) {
  const Disc to_the_right[] = {{{1, -0.2}, 0.3}}, to_the_left[] = {{{1, 0.2}, 0.3}};
  EXPECT_GT(step(seen(to_the_right, {}, {4, 0, 0, 0})).turn_rate, 0);
  EXPECT_LT(step(seen(to_the_left, {}, {4, 0, 0, 0})).turn_rate, 0);
}

TEST(VfhStep, sees_a_pole_that_one_beam_hits) {
  VfhIn in = seen({}, {}, {4, 0, 0, 0});
  in.scan.ranges[92] = 0.4f;  // 2 degrees to the left
  EXPECT_LT(step(in).turn_rate, -radians(1));
  EXPECT_LT(step(in).speed, 0.2);
}

TEST(VfhStep, slows_down_before_what_it_could_not_stop_at) {
  VfhOptions options;
  options.max_speed = options.max_speed_narrow = options.max_speed_wide = 1;
  options.free_cutoff = options.blocked_cutoff = {1e9, 1e9};  // the histogram says nothing here
  const Disc ahead[] = {{{1.5, 0}, 0.3}};
  VfhIn in = seen(ahead, {}, {4, 0, 0, 0});
  const double room = 1.2 - kRobot.radius - 0.1;
  EXPECT_LT(step(in, options).speed, std::sqrt(2 * 0.2 * (room + 0.1)));
  EXPECT_GT(step(in, options).speed, std::sqrt(2 * 0.2 * (room - 0.15)));
}

TEST(VfhStep, a_goal_in_front_of_an_obstacle_is_free) {
  const Disc behind[] = {{{1.5, 0}, 0.3}};
  const VfhOut out = step(seen(behind, {}, {0.8, 0, 0, 0}));
  EXPECT_NEAR(out.turn_rate, 0, 1e-12);
  EXPECT_DOUBLE_EQ(out.speed, 0.2);
  EXPECT_GT(std::abs(step(seen(behind, {}, {2.5, 0, 0, 0})).turn_rate), radians(1)) << "one behind it is not";
}

TEST(VfhStep, looks_round_when_everything_is_blocked) {
  VfhIn in = seen({}, {}, {4, 0, 0, 0});
  for (float& range : in.scan.ranges) range = 0.4f;
  const VfhOut out = step(in);
  EXPECT_EQ(out.speed, 0);
  EXPECT_DOUBLE_EQ(out.turn_rate, radians(40));
}

TEST(VfhStep, a_robot_that_moves_fast_does_not_turn_into_what_is_beside_it) {
  // Beside the robot on the left, within the circle of its sharpest turn at 1 m/s; free beyond it, where the
  // goal is.
  const Disc beside[] = {{{0.45, 0.55}, 0.1}};
  VfhOptions options;
  options.max_speed = options.max_speed_narrow = options.max_speed_wide = 1;
  options.free_cutoff = options.blocked_cutoff = {1e9, 1e9};  // the histogram says nothing here
  VfhIn in = seen(beside, {}, {1, 3, 0, 0});
  EXPECT_GT(step(in, options).turn_rate, radians(10)) << "at rest it turns on the spot";
  in.speed = 1;
  EXPECT_LT(step(in, options).turn_rate, radians(10));
}

TEST(VfhStep, between_the_cutoffs_a_direction_stays_what_it_was) {
  const Disc ahead[] = {{{1.4, 0}, 0.2}};
  VfhOptions options;
  options.free_cutoff = {1e3, 1e3};
  options.blocked_cutoff = {1e9, 1e9};
  const VfhIn in = seen(ahead, {}, {4, 0, 0, 0});
  VfhMemory was_free, was_blocked;
  was_free.blocked.assign(72, 0);
  was_blocked.blocked.assign(72, 0);
  for (int sector : {68, 69, 70, 71, 0, 1, 2, 3, 4})
    was_blocked.blocked[static_cast<std::size_t>(sector)] = 1;
  EXPECT_NEAR(vfh_step(options, kRobot, in, was_free).turn_rate, 0, 1e-12);
  EXPECT_GT(std::abs(vfh_step(options, kRobot, in, was_blocked).turn_rate), radians(10));
}

TEST(VfhStep, gathers_speed_no_faster_than_it_may) {
  VfhMemory memory;
  VfhIn in = seen({}, {}, {5, 0, 0, 0});
  for (int tick = 0; tick <= 20; ++tick) {
    in.time = 0.1 * tick;
    EXPECT_NEAR(vfh_step({}, kRobot, in, memory).speed, std::min(0.2, 0.02 * tick), 1e-9);
  }
}

TEST(VfhStep, at_the_goal_it_turns_to_the_heading_and_is_done) {
  const VfhOut turning = step(seen({}, {0.3, 0, 0, 0}, {0, 0, 0, radians(-90)}));
  EXPECT_EQ(turning.speed, 0);
  EXPECT_DOUBLE_EQ(turning.turn_rate, radians(-40));
  const VfhOut nearly = step(seen({}, {0.3, 0, 0, 0}, {0, 0, 0, radians(10.5)}));
  EXPECT_DOUBLE_EQ(nearly.turn_rate, radians(10)) << "no slower than a motor can";
  const VfhOut there = step(seen({}, {0.3, 0, 0, 0}, {0, 0, 0, radians(9)}));
  EXPECT_TRUE(there.done);
  EXPECT_EQ(there.turn_rate, 0);
}

TEST(VfhStep, escapes_from_a_stall_to_one_side_and_then_to_the_other) {
  VfhOptions options;
  options.escape_speed = -0.1;
  options.escape_time = 1;
  options.escape_turn_rate = 0.5;
  VfhMemory memory;
  VfhIn in = seen({}, {}, {5, 0, 0, 0});
  in.stall = true;
  VfhOut out = vfh_step(options, kRobot, in, memory);
  EXPECT_DOUBLE_EQ(out.speed, -0.1);
  EXPECT_DOUBLE_EQ(out.turn_rate, 0.5);
  in.stall = false;
  in.time = 0.9;
  EXPECT_DOUBLE_EQ(vfh_step(options, kRobot, in, memory).speed, -0.1) << "until its time is over";
  in.time = 1;
  EXPECT_GE(vfh_step(options, kRobot, in, memory).speed, 0);
  in.stall = true;
  EXPECT_DOUBLE_EQ(vfh_step(options, kRobot, in, memory).turn_rate, -0.5);
  EXPECT_GE(step(in).speed, 0) << "without the options a stall changes nothing";
}

TEST(VfhStep, a_scan_that_shows_nothing_stops_it) {
  VfhIn in = seen({}, {}, {5, 0, 0, 0});
  for (const double step_width : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    in.scan.angle_step = step_width;
    EXPECT_EQ(step(in).speed, 0);
    EXPECT_EQ(step(in).turn_rate, 0);
  }
  in.scan.ranges.clear();
  EXPECT_EQ(step(in).speed, 0);
}

TEST(VfhStep, a_range_that_is_no_number_is_an_obstacle) {
  VfhIn in = seen({}, {}, {4, 0, 0, 0});
  for (float& range : in.scan.ranges) range = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(step(in).speed, 0);
}

TEST(VfhStep, a_scanner_of_short_range_sees_nothing_beyond_it) {
  VfhIn in = seen({}, {}, {4, 0, 0, 0});
  in.scan.max_range = 0.5;
  for (float& range : in.scan.ranges) range = 0.5f;
  EXPECT_DOUBLE_EQ(step(in).speed, 0.2);
}

RC_GTEST_PROP(VfhStep, keeps_its_limits_and_never_drives_at_what_is_right_ahead, ()) {
  const auto number = [](double from, double to) {
    return from + (to - from) * static_cast<double>(*rc::gen::inRange(0, 1001)) / 1000;
  };
  std::vector<Disc> discs;
  for (int i = *rc::gen::inRange(0, 6); i > 0; --i)
    discs.push_back({{number(-2, 2), number(-2, 2)}, number(0.05, 0.5)});
  VfhIn in = seen(discs, {0, 0, 0, number(-3, 3)}, {number(-5, 5), number(-5, 5), 0, number(-3, 3)});
  in.speed = number(-0.2, 1);
  const VfhOptions options;
  const VfhOut out = step(in, options);
  RC_ASSERT(out.speed >= 0 && out.speed <= options.max_speed);
  RC_ASSERT(std::abs(out.turn_rate) <= options.max_turn_rate.at_rest + 1e-12);
  double ahead = 8;
  for (int beam = 80; beam <= 100; ++beam)
    ahead = std::min(ahead, static_cast<double>(in.scan.ranges[static_cast<std::size_t>(beam)]));
  if (ahead < kRobot.radius) RC_ASSERT(out.speed == 0);
}

TEST(VfhStep, gives_the_same_bits_again) {
  const Disc discs[] = {{{1, -0.2}, 0.3}, {{2, 1}, 0.4}};
  VfhMemory one, other;
  for (int tick = 0; tick < 50; ++tick) {
    VfhIn in = seen(discs, {0.01 * tick, 0, 0, 0.005 * tick}, {4, 0.5, 0, 0});
    in.time = 0.1 * tick;
    const VfhOut first = vfh_step({}, kRobot, in, one), second = vfh_step({}, kRobot, in, other);
    ASSERT_EQ(first.speed, second.speed);
    ASSERT_EQ(first.turn_rate, second.turn_rate);
  }
}

TEST(VfhStep, a_robot_gets_to_its_goal_between_discs_and_touches_none) {
  const Disc discs[] = {{{1.5, 0.1}, 0.3}, {{3, -0.8}, 0.4}, {{3, 1.6}, 0.4}, {{4.5, 0.3}, 0.3}};
  const geom::Pose X_OG{6, 0, 0, radians(90)};
  VfhOptions options;
  options.distance_epsilon = 0.1;
  VfhMemory memory;
  geom::Pose X_OR;
  double clearance = 8, speed = 0;
  for (int tick = 0; tick < 1000; ++tick) {
    VfhIn in = seen(discs, X_OR, X_OG);
    in.time = 0.1 * tick;
    in.speed = speed;
    const VfhOut out = vfh_step(options, kRobot, in, memory);
    if (out.done) break;
    speed = out.speed;
    X_OR = geom::compose(X_OR, {0.1 * out.speed, 0, 0, 0.1 * out.turn_rate});
    for (const Disc& disc : discs) {
      const Vec2 off = disc.p_OD - X_OR.xy();
      clearance = std::min(clearance, std::sqrt(dot(off, off)) - disc.radius - kRobot.radius);
    }
  }
  EXPECT_NEAR(X_OR.x, 6, 0.1);
  EXPECT_NEAR(X_OR.y, 0, 0.1);
  EXPECT_NEAR(geom::normalize(X_OR.a - X_OG.a), 0, radians(10));
  EXPECT_GT(clearance, 0.05);
}

}  // namespace
}  // namespace playhouse::drivers
