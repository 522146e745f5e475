#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "playhouse/arena/physics/testing_trials.h"

// Contacts against closed forms in ticks of any length: the tolerances are those of docs/arena.md.

namespace playhouse::arena {
namespace {

constexpr double kTicks[] = {0.001, 0.002, 0.005, 0.01, 0.05};  // s

Hull box(const Vec3& size, const Vec3& middle = {}) {
  Hull hull;
  for (const double z : {-0.5, 0.5})
    for (const auto& [x, y] : {std::pair(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
      hull.push_back(middle + Vec3{x * size.x, y * size.y, z * size.z});
  return hull;
}

RigidBodyDesc crate(const Vec3& size, const ContactSurface& surface = {}, double mass = 1) {
  return {.hulls = {box(size)}, .mass = mass, .center = {}, .surface = surface, .wheels = {}};
}

double length(const Vec3& v) {
  return std::sqrt(dot(v, v));
}

TEST(Contacts, what_loses_nothing_bounces_for_a_minute_as_high_as_it_fell) {
  for (const double tick : kTicks) {
    Trial trial(tick);
    const RigidBodyRow body =
        trial.add(crate({0.2, 0.2, 0.2}, {.friction = 0.6, .restitution = 1}), {.p = {0, 0, 1.1}});
    double highest = 0, last = 0, t = 0;
    trial.run(60, [&] {
      t += tick;
      const double height = trial.physics.state(body).p.z - 0.1;
      highest = std::max(highest, height);
      if (t > 58.5) last = std::max(last, height);
    });
    EXPECT_LE(highest, 1.001);
    EXPECT_GE(last, 0.99 - missed(tick));
  }
}

TEST(Contacts, a_rebound_is_of_the_height_that_restitution_says) {
  for (const double tick : kTicks)
    for (const double e : {0.3, 0.5, 0.8}) {
      Trial trial(tick);
      const RigidBodyRow body =
          trial.add(crate({0.2, 0.2, 0.2}, {.friction = 0.6, .restitution = e}), {.p = {0, 0, 1.1}});
      double highest = 0;
      bool has_hit = false;
      trial.run(1.2, [&] {
        const BodyState state = trial.physics.state(body);
        has_hit = has_hit || state.v.z > 0.1;
        if (has_hit) highest = std::max(highest, state.p.z - 0.1);
      });
      EXPECT_LE(highest, e * e + 0.001) << e;
      EXPECT_GE(highest, 0.99 * e * e - missed(tick)) << e;
    }
}

TEST(Contacts, equal_masses_exchange_their_velocities) {
  const ContactSurface surface{.friction = 1, .restitution = 1};
  for (const double tick : kTicks)
    for (const double gravity : {0.0, kG}) {
      Trial trial(tick, {.friction = 1e-9}, gravity);
      const RigidBodyRow moving =
          trial.add(crate({0.2, 0.2, 0.2}, surface), {.p = {0, 0, 0.1}, .v = {5.64, 0, 0}});
      const RigidBodyRow standing = trial.add(crate({0.2, 0.2, 0.2}, surface), {.p = {1, 0, 0.1}});
      trial.run(0.5);
      EXPECT_NEAR(trial.physics.state(moving).v.x, 0, 0.01) << gravity;
      EXPECT_NEAR(trial.physics.state(standing).v.x, 5.64, 0.01) << gravity;
    }
}

TEST(Contacts, a_wall_stops_what_is_fast) {
  const std::vector<FixedSolid> wall{{box({0.2, 6, 1}, {3, 0, 0.5}), {}}};
  for (const double tick : kTicks)
    for (const double speed : {10.0, 30.0}) {
      Trial trial(tick, {.friction = 0.1});
      trial.physics.set_fixed(wall);
      const RigidBodyRow small = trial.add(crate({0.2, 0.2, 0.2}), {.p = {0, 1, 0.1}, .v = {speed, 0, 0}}),
                         large = trial.add(crate({1, 1, 0.2}), {.p = {0, -1, 0.1}, .v = {speed, 0, 0}});
      double small_at = 0, large_at = 0;
      trial.run(1, [&] {
        small_at = std::max(small_at, trial.physics.state(small).p.x);
        large_at = std::max(large_at, trial.physics.state(large).p.x);
      });
      EXPECT_LE(small_at, 2.812) << speed;
      EXPECT_LE(large_at, 2.412) << speed;
      EXPECT_NEAR(trial.physics.state(small).p.x, 2.8, 0.1) << speed;
      EXPECT_NEAR(trial.physics.state(large).p.x, 2.4, 0.1) << speed;
    }
}

TEST(Contacts, nothing_falls_through_a_plate_or_into_the_ground) {
  const std::vector<FixedSolid> plate{{box({1, 1, 0.05}, {0, 0, 1}), {}}};
  for (const double tick : kTicks) {
    Trial trial(tick);
    trial.physics.set_fixed(plate);
    const RigidBodyRow above = trial.add(crate({0.05, 0.05, 0.05}), {.p = {0, 0, 6.05}}),
                       aside = trial.add(crate({0.2, 0.2, 0.2}), {.p = {3, 0, 10.1}});
    double above_low = 9, aside_low = 9;
    trial.run(2.5, [&] {
      above_low = std::min(above_low, trial.physics.state(above).p.z - 1.05);
      aside_low = std::min(aside_low, trial.physics.state(aside).p.z - 0.1);
    });
    EXPECT_GE(above_low, -0.012);
    EXPECT_GE(aside_low, -0.012);
    EXPECT_NEAR(trial.physics.state(above).p.z, 1.05, 0.003);
    EXPECT_NEAR(trial.physics.state(aside).p.z, 0.1, 0.003);
  }
}

constexpr double kSlope = 20 * std::numbers::pi / 180;  // rad
const Vec3 kUphill{std::cos(kSlope), 0, std::sin(kSlope)}, kOff{-std::sin(kSlope), 0, std::cos(kSlope)};

TEST(Contacts, what_friction_holds_on_a_slope_of_triangles_neither_shakes_nor_creeps) {
  for (const double tick : kTicks) {
    Trial trial(tick);
    trial.physics.set_fixed(square(4, 2, kSlope));
    const Vec3 begin = Vec3{0, 0, 2} + 0.25 * kOff;
    const RigidBodyRow body = trial.add(crate({0.5, 0.5, 0.5}, {.friction = 0.6}),
                                        {.p = begin, .q = geom::orientation(0, {0, -kSlope})});
    trial.run(0.5);
    Vec3 before = trial.physics.state(body).v;
    double shaken = 0;
    trial.run(0.5, [&] {
      const Vec3 now = trial.physics.state(body).v;
      shaken = std::max(shaken, length(now - before) / tick);
      before = now;
    });
    EXPECT_NEAR(shaken, 0, 0.01);
    trial.run(tick < 0.01 ? 4 : 59);
    EXPECT_NEAR(length(trial.physics.state(body).p - begin), 0, 0.003);
  }
}

// g (sin - mu cos) t^2 / 2
TEST(Contacts, what_slides_over_an_edge_between_triangles_goes_straight_on) {
  for (const double tick : kTicks) {
    Trial trial(tick);
    trial.physics.set_fixed(square(4, 2, kSlope));
    const Vec3 begin = Vec3{0, 0, 2} + 0.25 * kOff + 0.8 * kUphill;
    const RigidBodyRow body = trial.add(crate({0.5, 0.5, 0.5}, {.friction = 0.02}),
                                        {.p = begin, .q = geom::orientation(0, {0, -kSlope})});
    trial.run(1);
    const Vec3 way = trial.physics.state(body).p - begin;
    const double slid = 0.5 * kG * (std::sin(kSlope) - 0.02 * std::cos(kSlope));
    EXPECT_NEAR(dot(way, kUphill), -slid, 0.015 * slid);
    EXPECT_NEAR(way.y, 0, 0.002);
    EXPECT_NEAR(dot(way, kOff), 0, 0.002);

    Trial flat(tick);
    flat.physics.set_fixed(square(3, 0.5, 0));
    const RigidBodyRow sledge =
        flat.add(crate({0.5, 0.5, 0.5}, {.friction = 1e-6}), {.p = {-2, 0.5, 0.75}, .v = {2, 0, 0}});
    flat.run(1.5);
    const BodyState end = flat.physics.state(sledge);
    EXPECT_NEAR(length(end.p - Vec3{1, 0.5, 0.75}), 0, 0.002);
    EXPECT_NEAR(length(end.v - Vec3{2, 0, 0}), 0, 0.01);
  }
}

TEST(Contacts, crates_on_each_other_on_triangles_come_to_rest) {
  for (const double tick : kTicks) {
    Trial trial(tick);
    trial.physics.set_fixed(square(3, 0.5, 0));
    const RigidBodyRow below = trial.add(crate({0.5, 0.5, 0.5}, {.friction = 0.6}), {.p = {0.1, 0, 0.75}}),
                       above = trial.add(crate({0.4, 0.4, 0.4}, {.friction = 0.6}), {.p = {0.1, 0, 1.2}});
    trial.run(2);
    double fastest = 0, turning = 0;
    trial.run(0.5, [&] {
      for (const RigidBodyRow body : {below, above}) {
        fastest = std::max(fastest, length(trial.physics.state(body).v));
        turning = std::max(turning, length(trial.physics.state(body).w));
      }
    });
    EXPECT_LT(fastest, 0.005) << "so it may sleep";
    EXPECT_LT(turning, 0.02) << "so it may sleep";
  }
}

/// Twenty crates of 0.5 m: the top at 10 m, up to 2 mm of each contact, which Bullet leaves.
TEST(Contacts, a_stack_of_twenty_stays_up) {
  constexpr double kSide = 0.5;
  for (const double tick : kTicks) {
    Trial trial(tick, {.friction = 0.6});
    RigidBodyRow top;
    for (int i = 0; i < 20; ++i)
      top = trial.add(crate({kSide, kSide, kSide}, {.friction = 0.6}, 25), {.p = {0, 0, (i + 0.5) * kSide}});
    trial.run(tick < 0.01 ? 1.5 : 12);  // it fell within 10 s, in ticks of 10 ms
    const Vec3 p = trial.physics.state(top).p;
    EXPECT_NEAR(p.z, 19.5 * kSide, 0.045);
    EXPECT_LT(std::hypot(p.x, p.y), 0.03);
  }
}

TEST(Contacts, a_light_crate_bears_a_thousand_times_its_mass) {
  for (const double ratio : {10., 100., 1000.})
    for (const double tick : kTicks) {
      Trial trial(tick, {.friction = 0.6});
      const ContactSurface wood{.friction = 0.6};
      const RigidBodyRow light = trial.add(crate({0.5, 0.5, 0.5}, wood, 1), {.p = {0, 0, 0.25}}),
                         heavy = trial.add(crate({0.5, 0.5, 0.5}, wood, ratio), {.p = {0, 0, 0.75}});
      trial.run(10);
      const Vec3 below = trial.physics.state(light).p, above = trial.physics.state(heavy).p;
      EXPECT_NEAR(below.z, 0.25, 0.012) << ratio;
      EXPECT_NEAR(above.z, 0.75, 0.015) << ratio;
      EXPECT_LT(std::hypot(below.x, below.y), 0.02) << ratio;
      EXPECT_LT(std::hypot(above.x, above.y), 0.02) << ratio;
    }
}

}  // namespace
}  // namespace playhouse::arena
