#include "playhouse/record/frames.h"

#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/scene/world_loader.h"
#include "playhouse/world/camera.h"

namespace playhouse::record {
namespace {

using geom::SpatialPose;
using geom::Vec3;

constexpr const char* kWorld = R"(
position( name "r" pose [1 2 0 90] size [0.4 0.4 0.2] localization "odom" localization_origin [0 0 0 0]
  camera( name "eye" pose [0.3 0.1 0.2 -90] size [0.1 0.1 0.1] pantilt [0 0] tilt_limits [-90 90] )
  imu( name "imu" pose [0.1 0 0.2 30] ) )
)";

class FramesTest : public testing::Test {
 protected:
  /// Direction in W of an axis of a frame.
  static Vec3 turned(const SpatialPose& X, const Vec3& axis) {
    return geom::orientation(X.X.a, X.tilt) * axis;
  }
  static void expect_near(const Vec3& seen, const Vec3& wanted) {
    EXPECT_NEAR(seen.x, wanted.x, 1e-12);
    EXPECT_NEAR(seen.y, wanted.y, 1e-12);
    EXPECT_NEAR(seen.z, wanted.z, 1e-12);
  }
  static void expect_near(const SpatialPose& seen, const SpatialPose& wanted) {
    expect_near(Vec3{seen.X.x, seen.X.y, seen.X.z}, Vec3{wanted.X.x, wanted.X.y, wanted.X.z});
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
      expect_near(turned(seen, axis), turned(wanted, axis));
  }
  void tilt(const SpatialPose& X) {
    world_.upright = false;
    ASSERT_TRUE(world::set_spatial_pose(world_, robot_, X));
  }
  SpatialPose lens() const { return frame_in_world(world_, eye_, FrameKind::kLens); }

  config::MemoryFiles files_{{}};
  scene::SceneDesc scene_ = *scene::load_world_text(kWorld, "t.world", files_, {}, nullptr);
  world::World world_{scene_, 1};
  const world::ModelRow robot_ = world_.find("r"), eye_ = world_.find("r.eye"), imu_ = world_.find("r.imu");
};

TEST_F(FramesTest, of_a_lens_have_z_into_the_image_x_to_its_right_and_y_down) {
  // The robot looks to the north, and the camera to its right: to the east.
  expect_near(turned(lens(), {0, 0, 1}), {1, 0, 0});
  expect_near(turned(lens(), {1, 0, 0}), {0, -1, 0});
  expect_near(turned(lens(), {0, 1, 0}), {0, 0, -1});
  expect_near(Vec3{lens().X.x, lens().X.y, 0}, {0.9, 2.3, 0});
}

TEST_F(FramesTest, of_a_lens_follow_pan_and_tilt) {
  const world::CameraRow camera = world_.models.part[eye_];
  world_.cameras.pan[camera] = geom::radians(90);
  expect_near(turned(lens(), {0, 0, 1}), {0, 1, 0});
  for (const double tilt : {-90.0, -89.999999, 30.0, 90.0}) {
    world_.cameras.tilt[camera] = geom::radians(tilt);
    const double up = std::sin(geom::radians(tilt)), level = std::cos(geom::radians(tilt));
    expect_near(turned(lens(), {0, 0, 1}), {0, level, up});
    expect_near(turned(lens(), {1, 0, 0}), {1, 0, 0});
  }
}

TEST_F(FramesTest, of_parts_stay_in_that_of_a_robot_that_tips_over) {
  const auto in_robot = [&](world::ModelRow model, FrameKind kind) {
    return pose_in(world::pose_in_world(world_.models, robot_), frame_in_world(world_, model, kind));
  };
  const SpatialPose lens_before = in_robot(eye_, FrameKind::kLens),
                    imu_before = in_robot(imu_, FrameKind::kBody);
  tilt({{5, -3, 1, 0.7}, {0.5, -0.3}});
  expect_near(in_robot(eye_, FrameKind::kLens), lens_before);
  expect_near(in_robot(imu_, FrameKind::kBody), imu_before);
  EXPECT_NEAR(imu_before.X.a, geom::radians(30), 1e-12);
}

TEST_F(FramesTest, of_odometry_have_the_robot_where_it_believes_to_be) {
  tilt({{5, -3, 1, 0.7}, {0.1, 0.2}});
  world_.positions.X_OM[world_.models.part[robot_]] = {4, -2, 0, 0.6};
  const SpatialPose X_WO = frame_in_world(world_, robot_, FrameKind::kOdometry);
  expect_near(geom::compose(X_WO, estimated_pose(world_, robot_)),
              world::pose_in_world(world_.models, robot_));
  EXPECT_EQ(X_WO.tilt, geom::Tilt{});
}

}  // namespace
}  // namespace playhouse::record
