#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "playhouse/arena/physics/round_solids.h"
#include "playhouse/arena/physics/testing_trials.h"

// Spheres and capsules against closed forms in ticks of any length: the tolerances are those of
// docs/arena.md.

namespace playhouse::arena {
namespace {

constexpr double kRollTicks[] = {0.001, 0.002, 0.005, 0.01, 0.02, 0.05};      // s
constexpr double kRadius = 0.1;                                               // m
constexpr double kHalf = 0.2;                                                 // m, half the length of an axis
const Quaternion kAcross = Quaternion{std::sqrt(0.5), std::sqrt(0.5), 0, 0};  // z to -y

/// A ball, capsule or cylinder, its axis across the way that it rolls.
RigidBodyDesc roller(Round round, const ContactSurface& surface = {}) {
  Hull hull = round == Round::kCylinder ? cylinder_hull(kRadius, kHalf)
                                        : round_hull(kRadius, round == Round::kSphere ? 0 : kHalf);
  for (Vec3& p : hull) p = kAcross * p;
  return {.hulls = {hull}, .mass = 2, .center = {}, .surface = surface, .wheels = {}};
}

constexpr Round kAll[] = {Round::kSphere, Round::kCapsule, Round::kCylinder};
constexpr const char* kNames[] = {"polyhedron", "sphere", "capsule", "cylinder"};
const char* name_of(Round round) {
  return kNames[static_cast<int>(round)];
}

double size_of(const Vec3& v) {
  return std::sqrt(dot(v, v));
}

/// A plate of 8 m with its upper side at `height`, tilted about y.
std::vector<FixedSolid> plate(double height, double slope) {
  FixedSolid solid;
  const Quaternion q = geom::orientation(0, {0, -slope});
  for (const double x : {-4.0, 4.0})
    for (const double y : {-4.0, 4.0})
      for (const double z : {-0.2, 0.0}) solid.hull.push_back(Vec3{0, 0, height} + q * Vec3{x, y, z});
  return {solid};
}

/// Speed downhill after a second from rest on a slope.
double speed_after_a_second(double tick, const RigidBodyDesc& body, const std::vector<FixedSolid>& slope,
                            double angle) {
  Trial trial(tick);
  trial.physics.set_fixed(slope);
  const Vec3 off{-std::sin(angle), 0, std::cos(angle)}, uphill{std::cos(angle), 0, std::sin(angle)};
  const Vec3 begin = Vec3{0, 0, 3} + 3 * uphill + kRadius * off;
  const RigidBodyRow row = trial.add(body, {.p = begin});
  double high = -1, low = 1;
  trial.run(1, [&] {
    const double over = dot(trial.physics.state(row).p - begin, off);
    high = std::max(high, over);
    low = std::min(low, over);
  });
  EXPECT_LT(high, 0.0011) << "it hops";
  EXPECT_GT(low, -0.0011) << "it sinks";
  const BodyState state = trial.physics.state(row);
  EXPECT_NEAR(state.v.y, 0, 1e-3);
  EXPECT_NEAR(state.p.y, 0, 1e-3);
  return -dot(state.v, uphill);
}

// g sin / (1 + I / (m r^2)): 5/7 of sliding for a ball, 2/3 for a cylinder.
TEST(RoundSolids, roll_down_a_slope_at_the_rate_of_their_inertia) {
  const double of_capsule = moments_of(roller(Round::kCapsule).hulls, {}, 1).y / (kRadius * kRadius);
  const double moments[] = {0, 0.4, of_capsule, 0.5};
  for (const double tick : kRollTicks)
    for (const double degrees : {3.0, 5.0, 20.0}) {
      const double angle = degrees * std::numbers::pi / 180, slides = kG * std::sin(angle);
      for (const auto& slope : {square(4, 3, angle), plate(3, angle)})
        for (const Round round : kAll) {
          const double rolls = slides / (1 + moments[static_cast<int>(round)]);
          EXPECT_NEAR(speed_after_a_second(tick, roller(round, {.friction = 0.8}), slope, angle), rolls,
                      0.003 * rolls)
              << degrees << " degrees, " << name_of(round) << (slope[0].hull.empty() ? " on triangles" : "");
          EXPECT_NEAR(speed_after_a_second(tick, roller(round, {.friction = 0}), slope, angle), slides,
                      0.003 * slides)
              << degrees << " degrees, " << name_of(round) << (slope[0].hull.empty() ? " on triangles" : "");
        }
    }
}

/// Rolls at 1 m/s for 3 s in the direction of x.
void expect_to_roll_on(double tick, Round round, const std::vector<FixedSolid>& floor, double height) {
  Trial trial(tick);
  trial.physics.set_fixed(floor);
  const Vec3 begin{-1.5, 0.4, height + kRadius};
  const RigidBodyRow body = trial.add(roller(round), {.p = begin, .v = {1, 0, 0}, .w = {0, 1 / kRadius, 0}});
  double bump = 0;
  trial.run(3, [&] { bump = std::max(bump, std::fabs(trial.physics.state(body).p.z - begin.z)); });
  const BodyState state = trial.physics.state(body);
  EXPECT_LT(bump, 1e-4) << name_of(round);
  EXPECT_NEAR(size_of(state.v - Vec3{1, 0, 0}), 0, 1e-3) << name_of(round);
  EXPECT_NEAR(size_of(state.p - begin - Vec3{3, 0, 0}), 0, 3e-3) << name_of(round);
}

TEST(RoundSolids, roll_over_level_ground_plates_and_edges_of_triangles_without_a_bump) {
  for (const double tick : kRollTicks)
    for (const Round round : kAll) {
      expect_to_roll_on(tick, round, {}, 0);
      expect_to_roll_on(tick, round, square(3, 0.5, 0), 0.5);
      expect_to_roll_on(tick, round, plate(0.5, 0), 0.5);
    }
}

TEST(RoundSolids, rebound_to_the_height_that_restitution_says) {
  for (const double tick : kRollTicks)
    for (const double e : {0.3, 0.5, 0.8})
      for (const auto& floor : {std::vector<FixedSolid>{}, square(3, 0, 0)}) {
        Trial trial(tick);
        trial.physics.set_fixed(floor);
        const RigidBodyRow body = trial.add(roller(Round::kSphere, {.friction = 0.6, .restitution = e}),
                                            {.p = {0.2, 0.1, 1 + kRadius}});
        double highest = 0;
        bool has_hit = false;
        trial.run(1.2, [&] {
          const BodyState state = trial.physics.state(body);
          has_hit = has_hit || state.v.z > 0.1;
          if (has_hit) highest = std::max(highest, state.p.z - kRadius);
        });
        EXPECT_LE(highest, e * e + 0.001) << e;
        EXPECT_GE(highest, 0.99 * e * e - missed(tick)) << e;
      }
}

/// On two balls of equal mass, after a central impact.
TEST(RoundSolids, of_equal_mass_exchange_their_velocities) {
  for (const double tick : kRollTicks)
    for (const Round round : kAll) {
      Trial trial(tick, {.friction = 0}, 0);
      const RigidBodyDesc body = roller(round, {.friction = 0, .restitution = 1});
      const RigidBodyRow moving = trial.add(body, {.p = {0, 0, 1}, .v = {3, 0, 0}}),
                         standing = trial.add(body, {.p = {1, 0, 1}});
      trial.run(0.5);
      EXPECT_NEAR(size_of(trial.physics.state(moving).v), 0, 0.01) << name_of(round);
      EXPECT_NEAR(size_of(trial.physics.state(standing).v - Vec3{3, 0, 0}), 0, 0.01) << name_of(round);
    }
}

/// Expects so little motion after a second that it may sleep, where it was put.
void expect_to_rest(Trial& trial, RigidBodyRow body) {
  const Vec3 begin = trial.physics.state(body).p;
  trial.run(1);
  double fastest = 0, turning = 0;
  trial.run(1, [&] {
    fastest = std::max(fastest, size_of(trial.physics.state(body).v));
    turning = std::max(turning, size_of(trial.physics.state(body).w));
  });
  EXPECT_LT(fastest, 0.005);
  EXPECT_LT(turning, 0.02);
  EXPECT_NEAR(size_of(trial.physics.state(body).p - begin), 0, 0.003);
}

TEST(RoundSolids, at_rest_stay_where_they_are) {
  for (const double tick : kRollTicks) {
    for (const Round round : kAll) {
      Trial trial(tick);
      trial.physics.set_fixed(square(1, 0.5, 0));
      expect_to_rest(trial, trial.add(roller(round), {.p = {3, 0, kRadius}}));
      expect_to_rest(trial, trial.add(roller(round), {.p = {0.3, 0.2, 0.5 + kRadius}}));
    }
    // Half over the edge of a table, on two points: its end and the edge.
    for (const auto& table : {square(1, 0.5, 0), plate(0.5, 0)}) {
      const double side = table[0].hull.empty() ? 1 : 4;
      for (const Round round : {Round::kCapsule, Round::kCylinder}) {
        Trial trial(tick);
        trial.physics.set_fixed(table);
        expect_to_rest(trial, trial.add(roller(round), {.p = {0.3, side - 0.03, 0.5 + kRadius}}));
      }
    }
  }
}

TEST(RoundSolids, stand_on_their_discs) {
  const RigidBodyDesc drum{
      .hulls = {cylinder_hull(0.3, 0.4)}, .mass = 20, .center = {}, .surface = {}, .wheels = {}};
  for (const double tick : kRollTicks)
    for (const auto& floor : {square(3, 0.5, 0), plate(0.5, 0)}) {
      Trial trial(tick);
      trial.physics.set_fixed(floor);
      expect_to_rest(trial, trial.add(drum, {.p = {5, 0, 0.4}}));
      expect_to_rest(trial, trial.add(drum, {.p = {0.3, 0.2, 0.9}}));
      const RigidBodyRow leaning = trial.add(drum, {.p = {5, 5, 0.5}, .q = geom::orientation(0, {0.2, 0})});
      trial.run(4);
      EXPECT_NEAR(trial.physics.state(leaning).p.z, 0.4, 0.003);
      EXPECT_NEAR((trial.physics.state(leaning).q * Vec3{0, 0, 1}).z, 1, 1e-5) << "it rocks to rest";
    }
}

TEST(RoundSolids, stand_on_each_other) {
  const RigidBodyDesc drum{
      .hulls = {cylinder_hull(0.3, 0.4)}, .mass = 20, .center = {}, .surface = {}, .wheels = {}};
  for (const double tick : kRollTicks) {
    Trial trial(tick);
    RigidBodyRow top;
    for (int i = 0; i < 5; ++i) top = trial.add(drum, {.p = {0.02 * i, 0, 0.4 + 0.8 * i}});
    expect_to_rest(trial, top);
  }
}

bool is_finite(const BodyState& state) {
  return std::isfinite(dot(state.p, state.p)) && std::isfinite(dot(state.v, state.v)) &&
         std::isfinite(dot(state.w, state.w));
}

// Neither their axes nor their middles say in which direction.
TEST(RoundSolids, on_one_axis_come_apart) {
  const RigidBodyDesc drum{
      .hulls = {cylinder_hull(0.3, 0.4)}, .mass = 20, .center = {}, .surface = {}, .wheels = {}};
  struct Pair {
    RigidBodyDesc body;
    double radius;
    Vec3 first, second;
  };
  const RigidBodyDesc log = roller(Round::kCylinder);
  const Pair pairs[] = {{drum, 0.3, {0, 0, 0.4}, {0, 0, 0.4}},
                        {drum, 0.3, {0, 0, 0.4}, {0, 0, 0.45}},
                        {log, kRadius, {0, 0, kRadius}, {0, 0, kRadius}},
                        {log, kRadius, {0, 0, kRadius}, {0, 0.15, kRadius}}};
  for (const double tick : kRollTicks)
    for (const Pair& pair : pairs) {
      Trial trial(tick);
      const RigidBodyRow first = trial.add(pair.body, {.p = pair.first}),
                         second = trial.add(pair.body, {.p = pair.second});
      trial.run(2);
      const BodyState a = trial.physics.state(first), b = trial.physics.state(second);
      ASSERT_TRUE(is_finite(a) && is_finite(b)) << pair.radius;
      EXPECT_GT(size_of(a.p - b.p), 2 * pair.radius - 0.01) << pair.radius;
    }
}

/// Eight walls 2 mm from a drum, and a floor whose triangle is met last.
std::vector<FixedSolid> well(double floor) {
  FixedSolid solid;
  Triangles& triangles = solid.triangles;
  const double corner = 0.302 / std::cos(std::numbers::pi / 8);
  for (int k = 0; k < 8; ++k) {
    const double angle = k * std::numbers::pi / 4;
    for (const double z : {floor, floor + 1})
      triangles.p.push_back({corner * std::cos(angle), corner * std::sin(angle), z});
  }
  for (std::uint32_t k = 0; k < 8; ++k) {
    const std::uint32_t a = 2 * k, b = 2 * ((k + 1) % 8);
    triangles.corner.push_back({b, a, a + 1});
    triangles.corner.push_back({b, a + 1, b + 1});
  }
  for (const Vec3& p : {Vec3{-60, 0, floor}, {10, -20, floor}, {10, 20, floor}}) triangles.p.push_back(p);
  triangles.corner.push_back({16, 17, 18});
  return {solid};
}

TEST(RoundSolids, stand_on_the_floor_of_a_well_whose_walls_are_near) {
  const RigidBodyDesc drum{
      .hulls = {cylinder_hull(0.3, 0.4)}, .mass = 20, .center = {}, .surface = {}, .wheels = {}};
  for (const double tick : kRollTicks) {
    Trial trial(tick);
    trial.physics.set_fixed(well(0.5));
    expect_to_rest(trial, trial.add(drum, {.p = {0, 0, 0.9}}));
  }
}

/// A level table from x = -1 to 1 and y = -1 to 1 of triangles with sides of 2 cm.
std::vector<FixedSolid> fine_table(double height) {
  FixedSolid solid;
  constexpr std::uint32_t kSides = 100;
  for (std::uint32_t i = 0; i <= kSides; ++i)
    for (std::uint32_t k = 0; k <= kSides; ++k)
      solid.triangles.p.push_back({-1 + 0.02 * i, -1 + 0.02 * k, height});
  for (std::uint32_t i = 0; i < kSides; ++i)
    for (std::uint32_t k = 0; k < kSides; ++k) {
      const std::uint32_t a = i * (kSides + 1) + k, b = a + kSides + 1;
      solid.triangles.corner.push_back({a, b, b + 1});
      solid.triangles.corner.push_back({a, b + 1, a + 1});
    }
  return {solid};
}

// Of the hundreds of edges below a capsule, the outermost at the table's edge bear it.
TEST(RoundSolids, rest_and_roll_on_small_triangles_as_on_large_ones) {
  Trial trial(0.01);
  trial.physics.set_fixed(fine_table(0.5));
  const Vec3 begin{-0.9, -0.1, 0.5 + kRadius};
  const RigidBodyRow rolling =
      trial.add(roller(Round::kCapsule), {.p = begin, .v = {1, 0, 0}, .w = {0, 1 / kRadius, 0}});
  trial.run(1);
  EXPECT_NEAR(size_of(trial.physics.state(rolling).p - begin - Vec3{1, 0, 0}), 0, 3e-3);
  expect_to_rest(trial, trial.add(roller(Round::kCapsule), {.p = {-0.301, 0.97, 0.5 + kRadius}}));
}

/// A log on two others, that friction holds together.
TEST(RoundSolids, lie_on_each_other) {
  for (const double tick : kRollTicks)
    for (const Round round : {Round::kCapsule, Round::kCylinder}) {
      Trial trial(tick);
      trial.add(roller(round), {.p = {-kRadius, 0, kRadius}});
      trial.add(roller(round), {.p = {kRadius, 0, kRadius}});
      const RigidBodyRow top = trial.add(roller(round), {.p = {0, 0, kRadius * (1 + std::sqrt(3.0))}});
      trial.run(1);
      expect_to_rest(trial, top);
    }
}

TEST(RoundSolids, are_carried_by_crates) {
  for (const double tick : kRollTicks) {
    Trial trial(tick);
    Hull box;
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5})
        for (const double z : {-0.2, 0.2}) box.push_back({x, y, z});
    const RigidBodyDesc crate{.hulls = {box}, .mass = 4, .center = {}, .surface = {}, .wheels = {}};
    trial.add(crate, {.p = {0, 0, 0.2}});
    const RigidBodyRow log = trial.add(roller(Round::kCapsule), {.p = {0.1, 0.1, 0.4 + kRadius}});
    trial.add(crate, {.p = {3, 0, 0.2}});
    const RigidBodyRow drum = trial.add(roller(Round::kCylinder), {.p = {3.1, 0.1, 0.4 + kRadius}});
    expect_to_rest(trial, log);
    expect_to_rest(trial, drum);
  }
}

TEST(RoundSolids, are_stopped_by_walls) {
  for (const double tick : kRollTicks)
    for (const double speed : {3.0, 30.0}) {
      Trial trial(tick);
      FixedSolid wall;
      for (const double x : {2.9, 3.1})
        for (const double y : {-3.0, 3.0})
          for (const double z : {0.0, 1.0}) wall.hull.push_back({x, y, z});
      trial.physics.set_fixed(std::vector<FixedSolid>{wall});
      const RigidBodyRow ball =
          trial.add(roller(Round::kSphere, {.friction = 0}), {.p = {0, 0, kRadius}, .v = {speed, 0, 0}});
      double farthest = 0;
      trial.run(1.5, [&] { farthest = std::max(farthest, trial.physics.state(ball).p.x); });
      EXPECT_LE(farthest, 2.812) << speed;
      EXPECT_LT(std::fabs(trial.physics.state(ball).v.x), 0.12) << speed;
    }
}

// Sums of thin discs.
TEST(RoundSolids, have_the_moments_of_their_shape) {
  const double r = kRadius, m = 3;
  const Vec3 ball = moments_of(std::vector<Hull>{round_hull(r, 0)}, {}, m);
  for (const double moment : {ball.x, ball.y, ball.z}) EXPECT_NEAR(moment, 0.4 * m * r * r, 1e-12);
  const Vec3 cylinder = moments_of(std::vector<Hull>{cylinder_hull(r, 0.25)}, {}, m);
  EXPECT_NEAR(cylinder.z, 0.5 * m * r * r, 1e-12);
  EXPECT_NEAR(cylinder.x, m * (3 * r * r + 0.25) / 12, 1e-12);
  const double half = 0.25;
  double volume = 0, along = 0, across = 0;
  constexpr int kDiscs = 200'000;
  const double thick = 2 * (half + r) / kDiscs;
  for (int i = 0; i < kDiscs; ++i) {
    const double z = (i + 0.5) * thick - half - r, over = std::max(0.0, std::fabs(z) - half);
    const double radius2 = r * r - over * over, disc = std::numbers::pi * radius2 * thick;
    volume += disc;
    along += disc * radius2 / 2;
    across += disc * (radius2 / 4 + z * z);
  }
  const Vec3 capsule = moments_of(std::vector<Hull>{round_hull(r, half)}, {}, m);
  EXPECT_NEAR(capsule.z, along * m / volume, 1e-9);
  EXPECT_NEAR(capsule.x, across * m / volume, 1e-9);
  EXPECT_NEAR(capsule.y, across * m / volume, 1e-9);
  // Two balls on a bar without mass.
  Hull left = round_hull(r, 0), right = left;
  for (Vec3& p : left) p.x -= 0.5;
  for (Vec3& p : right) p.x += 0.5;
  const Vec3 two = moments_of(std::vector<Hull>{left, right}, {}, m);
  EXPECT_NEAR(two.x, 0.4 * m * r * r, 1e-12);
  EXPECT_NEAR(two.z, 0.4 * m * r * r + m * 0.25, 1e-12);
}

TEST(RoundSolids, are_where_the_corners_of_their_hull_are) {
  Hull hull = round_hull(0.3, 0.5);
  const Quaternion q = geom::orientation(1, {0.4, -0.3});
  const Vec3 p{2, -1, 5};
  for (Vec3& corner : hull) corner = p + q * corner;
  const RoundSolid solid = round_of(hull);
  EXPECT_NEAR(solid.radius, 0.3, 1e-12);
  EXPECT_NEAR(size_of(solid.low - p - q * Vec3{0, 0, -0.5}), 0, 1e-12);
  EXPECT_NEAR(size_of(solid.high - p - q * Vec3{0, 0, 0.5}), 0, 1e-12);
  EXPECT_EQ(round_hull(0.3, 0).round, Round::kSphere);
  EXPECT_EQ(round_hull(0.3, 1e-12).round, Round::kSphere);
  EXPECT_EQ(cylinder_hull(0.3, 0).round, Round::kNot);
  EXPECT_EQ(cylinder_hull(0, 0.3).round, Round::kNot);
}

}  // namespace
}  // namespace playhouse::arena
