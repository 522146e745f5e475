#include <gtest/gtest.h>

#include <limits>

#include "playhouse/behaviour/generated/acts.h"
#include "playhouse/world/camera.h"

namespace playhouse::behaviour {
namespace {

/// A camera that somebody has open, in a world of ten ticks a second; it turns by 9 degrees a tick.
class CameraActTest : public ::testing::Test {
 protected:
  CameraActTest() : scene_(make_scene()), world_(scene_, 1) { world::subscribe(world_, {0}); }

  void act(int ticks = 1) {
    for (int k = 0; k < ticks; ++k) phase_->act(world_, workers_);
  }
  double pan() const { return geom::degrees(world_.cameras.pan[{0}]); }
  double tilt() const { return geom::degrees(world_.cameras.tilt[{0}]); }
  double zoom() const { return geom::degrees(world_.cameras.zoom[{0}]); }
  void aim(double pan, double tilt, double zoom) {
    EXPECT_TRUE(
        world::aim_camera(world_, {0}, {geom::radians(pan), geom::radians(tilt), geom::radians(zoom)}));
  }

 private:
  static scene::SceneDesc make_scene() {
    scene::SceneDesc scene;
    scene::ModelDesc& camera = scene.models.emplace_back();
    camera.kind = scene::ModelKind::kCamera;
    camera.camera.emplace();
    return scene;
  }

 protected:
  scene::SceneDesc scene_;
  world::World world_;
  world::Workers workers_{1};
  std::unique_ptr<ActPhase> phase_ = make_camera_act();
};

TEST_F(CameraActTest, goes_where_it_is_told_as_fast_as_it_can_and_stops_there) {
  aim(20, -4, 0);
  act();
  EXPECT_DOUBLE_EQ(pan(), 9);
  EXPECT_DOUBLE_EQ(tilt(), -4);
  EXPECT_DOUBLE_EQ(geom::degrees(world_.cameras.pan_speed[{0}]), 90);
  act(2);
  EXPECT_DOUBLE_EQ(pan(), 20);
  EXPECT_NEAR(geom::degrees(world_.cameras.pan_speed[{0}]), 20, 1e-9);
  act();
  EXPECT_EQ(world_.cameras.pan_speed[{0}], 0);
  EXPECT_DOUBLE_EQ(zoom(), 70) << "a zoom of 0 changes nothing";
}

TEST_F(CameraActTest, stays_within_its_limits) {
  aim(170, 80, 200);
  act(30);
  EXPECT_DOUBLE_EQ(pan(), 100);
  EXPECT_DOUBLE_EQ(tilt(), 25);
  EXPECT_DOUBLE_EQ(zoom(), 70);
  aim(0, 0, 1);
  act(30);
  EXPECT_DOUBLE_EQ(zoom(), 5);
}

TEST_F(CameraActTest, turns_at_a_velocity_until_its_limits_and_stops_when_the_mode_changes) {
  world::set_camera_mode(world_, {0}, world::ControlMode::kVelocity);
  EXPECT_TRUE(world::turn_camera(world_, {0}, geom::radians(-50), geom::radians(500)));
  act();
  EXPECT_DOUBLE_EQ(pan(), -5);
  EXPECT_DOUBLE_EQ(tilt(), 9);
  act(40);
  EXPECT_DOUBLE_EQ(pan(), -100);
  EXPECT_DOUBLE_EQ(tilt(), 25);
  EXPECT_EQ(world_.cameras.pan_speed[{0}], 0) << "at its limit it stands";
  world::turn_camera(world_, {0}, geom::radians(50), 0);
  act();
  world::set_camera_mode(world_, {0}, world::ControlMode::kPosition);
  act(5);
  EXPECT_DOUBLE_EQ(pan(), -95);
}

TEST_F(CameraActTest, stands_still_while_nobody_has_it_open) {
  aim(20, 0, 0);
  world::unsubscribe(world_, {0});
  act(5);
  EXPECT_EQ(pan(), 0);
  world::watch(world_, {0});
  act(5);
  EXPECT_EQ(pan(), 0) << "who only looks changes nothing";
}

TEST_F(CameraActTest, takes_no_number_that_is_not_finite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(world::aim_camera(world_, {0}, {kNan, 0, 0}));
  EXPECT_FALSE(world::turn_camera(world_, {0}, 0, std::numeric_limits<double>::infinity()));
  act(5);
  EXPECT_EQ(pan(), 0);
}

}  // namespace
}  // namespace playhouse::behaviour
