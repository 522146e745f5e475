#include "playhouse/arena/physics/physics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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

RigidBodyDesc rover() {
  RigidBodyDesc desc;
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
      if (i % 10 == 0) physics_.clear_contacts();
      physics_.step(kStep, workers_);
    }
  }
  Physics physics_;
  world::Workers workers_{1};
};

TEST_F(PhysicsTest, drives_five_metres_and_turns_ten_radians_as_its_wheels_say) {
  const RigidBodyRow body = physics_.add(rover());
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

// At the limit of its grip F = mu (m g - N) on the axle, and the caster behind it, at a distance d, bears N =
// F h / d of a body whose centre is at a height h: it speeds up by mu g / (1 + mu h / d).
TEST_F(PhysicsTest, a_vehicle_of_any_height_speeds_up_as_its_grip_lets_it) {
  const double mu = 0.8, d = 0.16;
  for (const double height : {0.2, 0.5, 1.0, 1.5}) {
    RigidBodyDesc desc;
    desc.hulls = {box(0.4, 0.4, 0.03, height)};
    desc.mass = 10;
    desc.center = {0, 0, 0.3 * height};
    for (const double y : {-0.16, 0.16}) desc.wheels.push_back({{0, y, 0}, mu, mu});
    for (const double x : {-d, d}) desc.wheels.push_back({{x, 0, 0}, 0, 0});
    Physics physics;
    const RigidBodyRow body = physics.add(desc);
    physics.step(kStep, workers_);
    physics.drive(body, {5, 0, 0, 0});
    for (int i = 0; i < 20; ++i) physics.step(kStep, workers_);
    const double expected = mu * 9.81 / (1 + mu * desc.center.z / d);
    EXPECT_NEAR(physics.state(body).v.x, 0.2 * expected, 0.01 * expected) << height;
    physics.put(body, {}, false);
    physics.drive(body, {0, 0, 0, 1});
    for (int i = 0; i < 100; ++i) physics.step(kStep, workers_);
    EXPECT_NEAR(heading(physics.state(body).q), 1, 0.1) << height;
  }
}

// A box that slides at v0 stops after v0^2 / (2 mu g).
TEST_F(PhysicsTest, a_box_slides_as_far_as_friction_lets_it) {
  RigidBodyDesc desc;
  desc.hulls = {box(0.3, 0.3, 0, 0.1)};
  desc.center = {0, 0, 0.05};
  desc.surface.friction = 0.4;
  const RigidBodyRow body = physics_.add(desc);
  physics_.put(body, {.v = {2, 0, 0}}, false);
  run(2);
  EXPECT_NEAR(physics_.state(body).p.x, 2 * 2 / (2 * 0.4 * 9.81), 0.02);
}

/// A ramp of 10 m that rises along x.
struct Ramp {
  explicit Ramp(double angle)
      : along{std::cos(angle), 0, std::sin(angle)},
        up{-std::sin(angle), 0, std::cos(angle)},
        q(geom::orientation(0, {0, -angle})) {
    for (const double depth : {-0.5, 0.0})
      for (const auto& [x, y] : {std::pair(0.0, -5.0), {10.0, -5.0}, {10.0, 5.0}, {0.0, 5.0}})
        hull.push_back(x * along + Vec3{0, y, 0} + depth * up);
  }
  Vec3 along, up;  // unit vectors in its surface and normal to it
  Quaternion q;    // of what stands on it
  Hull hull;
};

// On a ramp it stays where tan(angle) is below the coefficient of friction, and slides above: at
// g (sin - mu cos) t^2 / 2.
TEST_F(PhysicsTest, slopes_hold_vehicles_and_boxes_as_friction_says) {
  const double angle = 20 * M_PI / 180;
  const Ramp ramp(angle);
  const Vec3 &along = ramp.along, &up = ramp.up;
  const FixedSolid solid{ramp.hull, {}};
  physics_.set_fixed({&solid, 1});
  RigidBodyDesc icy;
  icy.hulls = {box(0.3, 0.3, 0, 0.1)};
  icy.center = {0, 0, 0.05};
  icy.surface.friction = 0.1;
  const RigidBodyRow rover_body = physics_.add(rover()), box_body = physics_.add(icy);
  physics_.put(rover_body, {.p = 5 * along + 1e-3 * up, .q = ramp.q}, false);
  physics_.put(box_body, {.p = 5 * along + Vec3{0, 2, 0}, .q = ramp.q}, false);
  run(0.2);
  const Vec3 parked = physics_.state(rover_body).p;
  run(0.8);
  EXPECT_NEAR(dot(physics_.state(rover_body).p - parked, along), 0, 1e-3);
  const double slid = 0.5 * 9.81 * (std::sin(angle) - 0.1 * std::cos(angle));
  EXPECT_NEAR(dot(5 * along - physics_.state(box_body).p, along), slid, 0.03 * slid);
}

RigidBodyDesc slab(double mass, double length, double height, double friction) {
  RigidBodyDesc desc;
  desc.hulls = {box(length, 1, 0, height)};
  desc.mass = mass;
  desc.center = {0, 0, 0.5 * height};
  desc.surface.friction = friction;
  return desc;
}

/// How far a vehicle of a height, with wheels and casters of a `diff` base, slides down a ramp of 20 degrees.
double slides(double height, double friction, double heading) {
  const Ramp ramp(20 * M_PI / 180);
  RigidBodyDesc desc;
  desc.hulls = {box(0.4, 0.4, 0.03, height)};
  desc.mass = 10;
  desc.center = {0, 0, 0.3 * height};
  for (const double y : {-0.16, 0.16}) desc.wheels.push_back({{0, y, 0}, 0.8, 0.8});
  for (const double x : {-0.16, 0.16}) desc.wheels.push_back({.p_B = {x, 0, 0}, .brake = 0.8});
  Physics physics;
  world::Workers workers{1};
  const FixedSolid solid{ramp.hull, {.friction = friction}};
  physics.set_fixed({&solid, 1});
  const RigidBodyRow body = physics.add(desc);
  physics.put(body, {.p = 5 * ramp.along + 1e-3 * ramp.up, .q = ramp.q * geom::orientation(heading, {})},
              false);
  for (int i = 0; i < 20; ++i) physics.step(kStep, workers);
  const Vec3 parked = physics.state(body).p;
  for (int i = 0; i < 200; ++i) physics.step(kStep, workers);
  return dot(parked - physics.state(body).p, ramp.along);
}

// Where tan(angle) is below the friction of wheels and casters, whatever part the casters bear.
TEST(Physics, a_vehicle_that_is_to_stand_still_does_so_on_a_slope) {
  for (const double height : {0.22, 1.0})
    for (const double heading : {0.0, 0.5, 0.5 * M_PI, M_PI}) {
      EXPECT_NEAR(slides(height, 1, heading), 0, 2e-3) << height << " " << heading;
      EXPECT_NEAR(slides(height, 0.6, heading), 0, 2e-3) << height << " " << heading;
      EXPECT_GT(slides(height, 0.3, heading), 0.1) << height << " " << heading;
    }
}

// It rises to e^2 of the height from which it fell, with the larger coefficient of restitution of the two.
// The correction of its penetration, of up to 4 cm at the impact, adds at most a fifth of a metre.
TEST(Physics, a_body_bounces_as_high_as_restitution_lets_it) {
  for (const auto& [own, floor] : {std::pair(0.6, 0.1), {0.1, 0.6}, {0.8, 0.0}, {0.0, 0.0}}) {
    Physics physics({.restitution = floor});
    world::Workers workers{1};
    RigidBodyDesc desc = slab(5, 1, 0.2, 1);
    desc.surface.restitution = own;
    const RigidBodyRow body = physics.add(desc);
    physics.put(body, {.p = {0, 0, 1}}, false);
    bool fell = false;
    double highest = 0;
    for (int i = 0; i < 1000; ++i) {
      physics.step(kStep, workers);
      const BodyState state = physics.state(body);
      fell = fell || state.p.z < 0.05;
      if (fell) highest = std::max(highest, state.p.z);
    }
    const double e = std::max(own, floor);
    EXPECT_GE(highest, e * e - 0.01) << own << " " << floor;
    EXPECT_LE(highest, e * e + (e > 0 ? 0.2 : 0.05)) << own << " " << floor;
  }
}

/// How far a box slides that begins with 2 m/s along d.  [m]
double slide(const ContactSurface& ground, const ContactSurface& surface, double gravity, const Vec3& d) {
  Physics physics(ground, gravity);
  world::Workers workers{1};
  RigidBodyDesc desc = slab(5, 1, 0.2, 0);
  desc.surface = surface;
  const RigidBodyRow body = physics.add(desc);
  physics.put(body, {.v = 2 * d}, false);
  for (int i = 0; i < 1000; ++i) {
    if (i % 10 == 0) physics.clear_contacts();
    physics.step(kStep, workers);
  }
  const Vec3 p = physics.state(body).p;
  return std::sqrt(p.x * p.x + p.y * p.y);
}

// v^2 / (2 mu g)
TEST(Physics, a_box_slides_as_far_as_ground_gravity_and_its_grain_let_it) {
  const ContactSurface half{.friction = 0.5}, icy{.friction = 0.2};
  EXPECT_NEAR(slide({}, half, 9.81, {1, 0, 0}), 2 / (0.5 * 9.81), 0.02);
  EXPECT_NEAR(slide({}, half, 1.62, {1, 0, 0}), 2 / (0.5 * 1.62), 0.05);
  EXPECT_NEAR(slide(icy, half, 9.81, {1, 0, 0}), 2 / (0.1 * 9.81), 0.05);
  const ContactSurface sledge{.friction = 0.5, .share_x = 0.2};
  EXPECT_NEAR(slide({}, sledge, 9.81, {1, 0, 0}), 2 / (0.1 * 9.81), 0.1 * 2.04);
  EXPECT_NEAR(slide({}, sledge, 9.81, {0, 1, 0}), 2 / (0.5 * 9.81), 0.1 * 0.41);
}

TEST_F(PhysicsTest, wheels_slip_along_the_grain_of_a_floor) {
  const ContactSurface grain{.friction = 1, .share_x = 0.02};
  const std::vector<FixedSolid> floor{{box(40, 40, -1, 0.01), grain, 0.5 * std::numbers::pi}};
  physics_.set_fixed(floor);
  const RigidBodyRow along = physics_.add(rover()), across = physics_.add(rover());
  physics_.put(along, {.p = {0, 0, 0.01}, .q = geom::orientation(0.5 * std::numbers::pi, {})}, false);
  physics_.put(across, {.p = {5, 0, 0.01}}, false);
  physics_.drive(along, {1, 0, 0, 0});
  physics_.drive(across, {1, 0, 0, 0});
  run(1);
  // Half of the weight or more is on the wheels, of which the grip is 0.8; the casters have the rest.
  EXPECT_GE(physics_.state(along).v.y, 0.02 * 0.8 * 0.5 * 9.81);
  EXPECT_LE(physics_.state(along).v.y, 0.02 * 0.8 * 9.81);
  EXPECT_NEAR(physics_.state(across).v.x, 1, 0.01);
}

TEST_F(PhysicsTest, a_platform_that_moves_carries_the_vehicle_on_it) {
  const RigidBodyRow platform = physics_.add(slab(0, 2, 0.2, 1)), body = physics_.add(rover());
  physics_.put(body, {.p = {0, 0, 0.2}}, false);
  physics_.put(platform, {.v = {0.5, 0, 0.1}}, false);
  run(0.2);  // the wheels get it going
  const Vec3 begin = physics_.state(body).p - physics_.state(platform).p;
  run(3);
  const Vec3 end = physics_.state(body).p - physics_.state(platform).p;
  EXPECT_NEAR(physics_.state(platform).p.x, 1.6, 1e-9);
  EXPECT_NEAR(end.x, begin.x, 1e-3);
  EXPECT_NEAR(end.y, 0, 1e-3);
  EXPECT_NEAR(end.z, 0.2, 2e-3);
}

TEST_F(PhysicsTest, what_a_vehicle_drives_off_from_goes_the_other_way) {
  physics_.add(slab(0, 8, 0.1, 0));  // of ice
  const RigidBodyRow plank = physics_.add(slab(18, 4, 0.1, 1)), body = physics_.add(rover());
  physics_.put(plank, {.p = {0, 0, 0.1}}, false);
  physics_.put(body, {.p = {-1, 0, 0.2}}, false);
  physics_.drive(body, {0.3, 0, 0, 0});
  run(2);
  const double ahead = physics_.state(body).v.x, back = physics_.state(plank).v.x;
  EXPECT_NEAR(ahead - back, 0.3, 1e-3) << "the wheels turn as fast as they are told to";
  EXPECT_NEAR(9 * ahead + 18 * back, 0, 0.02) << "nothing else pushes them along";
  EXPECT_NEAR(physics_.state(body).p.z - physics_.state(plank).p.z, 0.1, 2e-3);
}

TEST_F(PhysicsTest, a_vehicle_that_rests_falls_when_what_it_stands_on_is_pulled_away) {
  const RigidBodyRow slab_body = physics_.add(slab(50, 2, 0.3, 0)), body = physics_.add(rover());
  physics_.put(body, {.p = {0, 0, 0.3}}, true);
  physics_.put(slab_body, {}, true);
  run(1);
  EXPECT_EQ(physics_.state(body).p.z, 0.3) << "to the bit";
  EXPECT_TRUE(physics_.is_sleeping(body));
  physics_.put(slab_body, {.v = {3, 0, 0}}, false);
  run(1.5);
  EXPECT_FALSE(physics_.is_sleeping(body));
  EXPECT_GT(physics_.state(slab_body).p.x, 2.5);
  EXPECT_NEAR(physics_.state(body).p.z, 0, 5e-3);
}

RigidBodyDesc walker() {
  RigidBodyDesc person;
  person.hulls = {box(0.3, 0.4, 0.3, 1.7)};
  person.mass = 70;
  person.center = {0, 0, 0.8};
  person.is_upright = true;
  for (const auto& [x, y] : {std::pair(0.0, 0.0), {-0.15, -0.2}, {0.15, 0.2}, {-0.15, 0.2}, {0.15, -0.2}})
    person.wheels.push_back({{x, y, 0}, 1, 1, 0.3});
  return person;
}

TEST_F(PhysicsTest, who_walks_over_a_robot_does_not_tip_it) {
  const RigidBodyRow person = physics_.add(walker()), robot = physics_.add(rover());
  for (const double aside : {0.0, 0.15}) {
    physics_.put(person, {}, false);
    physics_.put(robot, {.p = {1, aside, 0}}, false);
    physics_.drive(person, {1, 0, 0, 0});
    for (int i = 0; i < 30; ++i) {
      run(0.1);
      EXPECT_GT((physics_.state(robot).q * Vec3{0, 0, 1}).z, 0.999) << aside;
    }
    EXPECT_GT(physics_.state(person).p.x, 2) << "it is over it";
  }
}

TEST_F(PhysicsTest, who_walks_steps_onto_what_is_loose_and_low) {
  const RigidBodyRow body = physics_.add(walker()), crate = physics_.add(slab(40, 2, 0.25, 1));
  physics_.put(crate, {.p = {1.5, 0, 0}}, false);
  physics_.drive(body, {1, 0, 0, 0});
  run(2);
  EXPECT_NEAR(physics_.state(body).p.x, 1.6, 0.5);
  EXPECT_NEAR(physics_.state(body).p.z, 0.25, 0.01);
  EXPECT_NEAR(physics_.state(crate).p.x, 1.5, 0.1);
  run(2);
  EXPECT_NEAR(physics_.state(body).p.z, 0, 0.01) << "and down again";
}

TEST_F(PhysicsTest, what_is_light_bears_who_stands_on_it) {
  for (const double mass : {2.0, 5.0, 20.0}) {
    const RigidBodyRow person = physics_.add(walker()), crate = physics_.add(slab(mass, 0.6, 0.25, 1));
    physics_.put(person, {.p = {0, 0, 0.25}}, false);
    run(3);
    EXPECT_NEAR(physics_.state(person).p.z, 0.25, 0.01) << mass;
    EXPECT_NEAR(physics_.state(person).p.x, 0, 0.1) << mass;
    EXPECT_NEAR(physics_.state(crate).p.x, 0, 0.1) << mass;
    EXPECT_NEAR(physics_.state(crate).p.z, 0, 0.01) << mass;
    physics_.clear();
  }
}

TEST_F(PhysicsTest, a_light_vehicle_bears_a_heavy_one) {
  RigidBodyDesc heavy = rover();
  heavy.mass = 50;
  const RigidBodyRow below = physics_.add(rover()), above = physics_.add(heavy);
  physics_.put(above, {.p = {0, 0, 0.22}}, false);
  run(3);
  EXPECT_NEAR(physics_.state(below).p.z, 0, 2e-3);
  EXPECT_NEAR(physics_.state(above).p.z, 0.22, 2e-3);
}

TEST_F(PhysicsTest, casters_give_way_at_the_foot_of_a_ramp) {
  const double slope = 10 * std::numbers::pi / 180, length = 4, rise = length * std::tan(slope);
  Hull ramp;
  for (const double y : {-1.0, 1.0})
    for (const Vec3& p : {Vec3{1, y, 0}, Vec3{1 + length, y, 0}, Vec3{1 + length, y, rise}})
      ramp.push_back(p);
  physics_.set_fixed(std::vector<FixedSolid>{{ramp, {1, 0}}});
  const RigidBodyRow body = physics_.add(rover());
  physics_.drive(body, {0.4, 0, 0, 0});
  run(6);
  const BodyState end = physics_.state(body);
  EXPECT_NEAR(end.p.x, 1 + (6 * 0.4 - 1) * std::cos(slope), 0.05);
  EXPECT_NEAR(end.p.z, (end.p.x - 1) * std::tan(slope), 0.01);
  EXPECT_NEAR(end.p.y, 0, 0.01);
}

TEST_F(PhysicsTest, seven_boxes_stand_on_each_other) {
  std::vector<RigidBodyRow> boxes;
  constexpr int kBoxes = 7;
  for (int i = 0; i < kBoxes; ++i) {
    RigidBodyDesc box_desc;
    box_desc.hulls = {box(0.4, 0.4, 0, 0.4)};
    box_desc.mass = 10;
    box_desc.center = {0, 0, 0.2};
    box_desc.surface = {0.6, 0};
    boxes.push_back(physics_.add(box_desc));
    physics_.put(boxes.back(), {.p = {0, 0, 0.4 * i}}, false);
  }
  run(15);
  for (int i = 0; i < kBoxes; ++i)
    EXPECT_NEAR(physics_.state(boxes[static_cast<std::size_t>(i)]).p.z, 0.4 * i, 0.02) << i;
}

TEST_F(PhysicsTest, a_vehicle_that_is_woken_from_above_goes_on_whatever_was_before) {
  RigidBodyDesc small = rover();
  small.hulls = {box(0.2, 0.2, 0.05, 0.2)};
  small.mass = 1;
  for (Wheel& wheel : small.wheels) wheel.p_B = 0.4 * wheel.p_B;
  const auto step_from = [&](double height_before) {
    Physics physics;
    const RigidBodyRow below = physics.add(rover()), above = physics.add(small);
    physics.put(below, {.p = {0, 0, height_before}}, false);
    physics.put(above, {.p = {5, 0, 0}}, false);
    physics.step(kStep, workers_);
    physics.put(below, {}, true);
    physics.put(above, {.p = {0, 0, 0.22}}, false);
    physics.clear_contacts();
    physics.step(kStep, workers_);
    EXPECT_FALSE(physics.is_sleeping(below));
    return physics.state(below).p.z;
  };
  EXPECT_EQ(step_from(0), step_from(2)) << "on the ground, or in the air";
}

}  // namespace
}  // namespace playhouse::arena
