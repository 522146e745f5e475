#include <gtest/gtest.h>
#include <limits>

#include "playhouse/behaviour/generated/acts.h"

namespace playhouse::behaviour {
namespace {

/// A slide from -1 to 2 m at no more than 0.5 m/s, in a world of ten ticks a second in which nothing is in
/// its way.
class Slide : public ::testing::Test {
 protected:
  Slide() { world::subscribe(world, {0}); }

  void step(int ticks = 1) {
    for (int k = 0; k < ticks; ++k) {
      phase_->act(world, workers_);
      world.actuators.position[{0}] += 0.1 * velocity();
    }
  }
  double velocity() const { return world.actuators.velocity[{0}]; }
  double position() const { return world.actuators.position[{0}]; }
  void go_to(double position) { EXPECT_TRUE(world::command_joint_position(world, kRow, position)); }
  void move_at(double velocity) { EXPECT_TRUE(world::command_joint_velocity(world, kRow, velocity)); }

  static constexpr world::ActuatorRow kRow{0};

 private:
  static scene::SceneDesc make_scene() {
    scene::SceneDesc scene;
    scene::ModelDesc& slide = scene.models.emplace_back();
    slide.kind = scene::ModelKind::kActuator;
    slide.actuator.emplace();
    slide.actuator->min_position = -1;
    slide.actuator->max_position = 2;
    slide.actuator->max_speed = 0.5;
    return scene;
  }

  const scene::SceneDesc scene_ = make_scene();
  world::Workers workers_{1};
  std::unique_ptr<ActPhase> phase_ = make_actuator_act();

 public:
  world::World world{scene_, 1};
};

TEST_F(Slide, keeps_a_speed_up_to_its_largest) {
  move_at(0.3);
  step();
  EXPECT_EQ(velocity(), 0.3);
  move_at(-7);
  step();
  EXPECT_EQ(velocity(), -0.5);
}

TEST_F(Slide, goes_to_a_position_the_slower_the_nearer_it_is_and_rests_there) {
  go_to(0.8);
  step();
  EXPECT_EQ(velocity(), 0.5);
  step(9);
  EXPECT_LT(velocity(), 0.4);
  EXPECT_NEAR(0.8 - position(), 0.9 * velocity(), 1e-12) << "what is left per second, less this tick's part";
  step(80);
  EXPECT_EQ(velocity(), 0);
  EXPECT_NEAR(position(), 0.8, 1e-12);
}

TEST_F(Slide, goes_to_a_position_no_faster_than_it_is_told) {
  world.actuators.speed[{0}] = 0.1;
  go_to(-0.5);
  step();
  EXPECT_EQ(velocity(), -0.1);
}

TEST_F(Slide, speeds_up_as_fast_as_it_is_told_and_brakes_at_its_goal) {
  world.actuators.acceleration[{0}] = 1;
  go_to(0.8);
  step();
  EXPECT_NEAR(velocity(), 0.1, 1e-12);
  step();
  EXPECT_NEAR(velocity(), 0.2, 1e-12);
  step(3);
  EXPECT_EQ(velocity(), 0.5);
  go_to(-1);
  step();
  EXPECT_NEAR(velocity(), -0.1, 1e-12) << "the other way round, from rest";
  step(100);
  EXPECT_NEAR(position(), -1, 1e-9);
  EXPECT_EQ(velocity(), 0);
  move_at(0.5);
  step();
  EXPECT_EQ(velocity(), 0.5) << "a velocity is as commanded";
}

TEST_F(Slide, ends_where_its_way_ends_whatever_it_is_told) {
  go_to(50);
  EXPECT_EQ(world.actuators.goal[{0}], 2);
  step(200);
  EXPECT_NEAR(position(), 2, 1e-9);
  EXPECT_EQ(velocity(), 0);
  move_at(-0.49);
  step(200);
  EXPECT_NEAR(position(), -1, 1e-9);
  EXPECT_EQ(velocity(), 0);
}

TEST_F(Slide, stands_still_without_power_or_with_brakes_or_when_nobody_has_it_open) {
  const auto expect_still = [&] {
    step();
    EXPECT_EQ(velocity(), 0);
  };
  move_at(0.3);
  world.actuators.motor_on[{0}] = 0;
  expect_still();
  world.actuators.motor_on[{0}] = 1;
  world.actuators.braked[{0}] = 1;
  expect_still();
  world.actuators.braked[{0}] = 0;
  step();
  EXPECT_EQ(velocity(), 0.3) << "what it was told is kept";
  world::unsubscribe(world, {0});
  expect_still();
}

TEST_F(Slide, refuses_what_is_no_number) {
  EXPECT_FALSE(world::command_joint_velocity(world, kRow, std::nan("")));
  EXPECT_FALSE(world::command_joint_position(world, kRow, std::numeric_limits<double>::infinity()));
}

}  // namespace
}  // namespace playhouse::behaviour
