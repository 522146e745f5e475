#include "playhouse/arena/physics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace playhouse::arena {
namespace {

constexpr double kStep = 0.01;  // s

Hull box(double x, double y, double z_low, double z_high) {
  Hull hull;
  for (const double z : {z_low, z_high})
    for (const auto& [sx, sy] : {std::pair(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
      hull.push_back({sx * x, sy * y, z});
  return hull;
}

BodyDesc rover() {
  BodyDesc desc;
  desc.hulls = {box(0.44, 0.38, 0.05, 0.22)};
  desc.mass = 9;
  desc.center = {-0.02, 0, 0.1};
  for (const double y : {-0.17, 0.17}) desc.wheels.push_back({{0, y, 0}, 0.8, 0.8});
  for (const double x : {-0.2, 0.2}) desc.wheels.push_back({{x, 0, 0}, 0, 0});
  return desc;
}

double heading(const Quaternion& q) {
  return 2 * std::atan2(q.z, q.w);
}

class PhysicsTest : public testing::Test {
 protected:
  void run(double seconds) {
    for (int i = 0; i < std::lround(seconds / kStep); ++i) {
      if (i % 10 == 0) physics_.forget();
      physics_.step(kStep, workers_);
    }
  }
  Physics physics_;
  world::Workers workers_{1};
};

TEST_F(PhysicsTest, drives_five_metres_and_turns_ten_radians_as_its_wheels_say) {
  const std::uint32_t body = physics_.add(rover());
  physics_.drive(body, {0.5, 0, 0, 0});
  run(0.1);
  const Vec3 begin = physics_.state(body).p;
  run(10);
  const Vec3 end = physics_.state(body).p;
  EXPECT_NEAR(end.x - begin.x, 5, 0.002 * 5);
  EXPECT_NEAR(end.y, 0, 0.002 * 5);

  physics_.put(body, {}, false);
  physics_.drive(body, {0, 0, 0, 1});
  run(0.1);
  double turned = 0, last = heading(physics_.state(body).q);
  for (int i = 0; i < 100; ++i) {
    run(0.1);
    const double now = heading(physics_.state(body).q);
    turned += std::remainder(now - last, 2 * M_PI);
    last = now;
  }
  EXPECT_NEAR(turned, 10, 0.002 * 10);
  EXPECT_NEAR(physics_.state(body).p.x, 0, 0.005);
}

// A box that slides at v0 stops after v0^2 / (2 mu g).
TEST_F(PhysicsTest, a_box_slides_as_far_as_friction_lets_it) {
  BodyDesc desc;
  desc.hulls = {box(0.3, 0.3, 0, 0.1)};
  desc.center = {0, 0, 0.05};
  desc.surface.friction = 0.4;
  const std::uint32_t body = physics_.add(desc);
  physics_.put(body, {.v = {2, 0, 0}}, false);
  run(2);
  EXPECT_NEAR(physics_.state(body).p.x, 2 * 2 / (2 * 0.4 * 9.81), 0.02);
}

// On a ramp it stays where tan(angle) is below the coefficient of friction, and slides above: at
// g (sin - mu cos) t^2 / 2.
TEST_F(PhysicsTest, slopes_hold_vehicles_and_boxes_as_friction_says) {
  const double angle = 20 * M_PI / 180;
  const Vec3 along{std::cos(angle), 0, std::sin(angle)}, up{-std::sin(angle), 0, std::cos(angle)};
  Hull ramp;
  for (const double depth : {-0.5, 0.0})
    for (const auto& [x, y] : {std::pair(0.0, -5.0), {10.0, -5.0}, {10.0, 5.0}, {0.0, 5.0}})
      ramp.push_back(x * along + Vec3{0, y, 0} + depth * up);
  const FixedSolid solid{ramp, {}};
  physics_.set_fixed({&solid, 1});
  BodyDesc icy;
  icy.hulls = {box(0.3, 0.3, 0, 0.1)};
  icy.center = {0, 0, 0.05};
  icy.surface.friction = 0.1;
  const Quaternion q = geom::orientation(0, {0, -angle});
  const std::uint32_t rover_body = physics_.add(rover()), box_body = physics_.add(icy);
  physics_.put(rover_body, {.p = 5 * along + 1e-3 * up, .q = q}, false);
  physics_.put(box_body, {.p = 5 * along + Vec3{0, 2, 0}, .q = q}, false);
  run(0.2);
  const Vec3 parked = physics_.state(rover_body).p;
  run(0.8);
  EXPECT_NEAR(dot(physics_.state(rover_body).p - parked, along), 0, 1e-3);
  const double slid = 0.5 * 9.81 * (std::sin(angle) - 0.1 * std::cos(angle));
  EXPECT_NEAR(dot(5 * along - physics_.state(box_body).p, along), slid, 0.03 * slid);
}

}  // namespace
}  // namespace playhouse::arena
