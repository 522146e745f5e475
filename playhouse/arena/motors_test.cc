#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "playhouse/arena/testing_runs.h"

namespace playhouse::arena {
namespace {

constexpr double kMass = 1000;    // kg
constexpr double kForce = 2000;   // N
constexpr double kPower = 10000;  // W

/// Of a tonne on level ground, in ticks of so many milliseconds.
class MotorsTest : public ArenaRun, public testing::WithParamInterface<int> {
 protected:
  /// `load`: models of the world file that it carries.
  void start(const std::string& words, const std::string& load = {}) {
    const std::string text = "interval_sim " + std::to_string(GetParam()) +
                             "\ndefine base position( size [2 1 0.5] mass 1000 localization \"gps\" "
                             "velocity_bounds [-50 50 -50 50 -1 1 "
                             "-90 90] " +
                             words + " )\nbase( name \"it\" pose [0 0 0 0] )\n" + load;
    config::MemoryFiles files({{std::string("w.world"), text}});
    Result<scene::SceneDesc> scene = scene::load_world_text(text, "w.world", files);
    ASSERT_TRUE(scene) << scene.error().line();
    ArenaRun::start(std::move(*scene));
  }
  double step() const { return std::min(1e-3 * GetParam(), 0.01); }  // s, of physics
  double speed() {
    const geom::SpatialVelocity& V = world().models.V_WM[world().find("it")];
    return std::hypot(V.v.x, V.v.y);
  }
};

TEST_P(MotorsTest, a_force_gives_the_mass_its_acceleration_and_takes_it_again) {
  for (const char* drive_word : {"diff", "omni", "car"}) {
    start("max_force 2000 drive \"" + std::string(drive_word) + "\"");
    drive("it", {20, 0, 0, 0});
    run(2);
    const double a = kForce / kMass;
    EXPECT_NEAR(speed(), a * 2, 0.01) << drive_word;
    EXPECT_NEAR(pose("it").x, 0.5 * a * 2 * (2 + step()), 0.02) << drive_word;
    drive("it", {0, 0, 0, 0});
    run(1);
    EXPECT_NEAR(speed(), a * 2 - a * 1, 0.01) << drive_word;
    run(1.5);
    EXPECT_NEAR(speed(), 0, 0.01) << drive_word;
  }
}

TEST_P(MotorsTest, wheels_that_are_driven_sideways_share_the_force_by_direction) {
  start("max_force 2000 drive \"omni\"");
  drive("it", {12, 16, 0, 0});
  run(2);
  EXPECT_NEAR(speed(), kForce / kMass * 2, 0.02);
  EXPECT_NEAR(std::atan2(pose("it").y, pose("it").x), std::atan2(16, 12), 0.02);
}

// Bullet moves the wheels of what carries a load, within what their motors have left.
TEST_P(MotorsTest, wheels_that_are_driven_sideways_share_the_force_with_a_load_as_well) {
  start("max_force 2000 drive \"omni\"",
        "model( name \"crate\" pose [0 0 0.5 0] size [0.3 0.3 0.3] mass 10 gripper_return 1 )\n");
  drive("it", {12, 16, 0, 0});
  run(2);
  EXPECT_NEAR(speed(), kForce * 2 / (kMass + 10), 0.03);
  EXPECT_NEAR(std::atan2(pose("it").y, pose("it").x), std::atan2(16, 12), 0.02);
  EXPECT_NEAR(pose("crate").x, pose("it").x, 0.1);
  EXPECT_NEAR(pose("crate").z, 0.5, 0.01);
}

// v² = 2 P t / m, from where the force ends.
TEST_P(MotorsTest, a_power_gives_the_mass_its_energy) {
  start("max_force 2000 max_power 10000");
  drive("it", {40, 0, 0, 0});
  run(5);
  const double v = kPower / kForce, t = v * kMass / kForce;  // until then by the force
  EXPECT_NEAR(speed(), std::sqrt(v * v + 2 * kPower * (5 - t) / kMass), 0.03);
  run(5);
  EXPECT_NEAR(speed(), std::sqrt(v * v + 2 * kPower * (10 - t) / kMass), 0.03);
}

TEST_P(MotorsTest, power_alone_is_limited_by_grip_first_and_slows_down_as_the_wheels_grip) {
  start("max_power 10000");
  drive("it", {40, 0, 0, 0});
  run(5);
  const double grip = 0.8 * 9.81, v = kPower / kMass / grip, t = v / grip;
  EXPECT_NEAR(speed(), std::sqrt(v * v + 2 * kPower * (5 - t) / kMass), 0.1);
  const double before = speed();
  drive("it", {0, 0, 0, 0});
  run(0.5);
  EXPECT_LT(speed(), before - 0.25 * grip) << "power is what motors give, not what brakes take";
}

INSTANTIATE_TEST_SUITE_P(Steps, MotorsTest, testing::Values(1, 2, 5, 10, 20, 50));

}  // namespace
}  // namespace playhouse::arena
