// What a pair of lenses tells of what it sees: disparities and points, by the geometry of a pinhole.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/bridge/simulated/model_interfaces.h"
#include "playhouse/bridge/testing/one_device.h"
#include "playhouse/wire/generated/stereo.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;
namespace stereo = wire::stereo;

// Of 4 x 2 pixels, its focal length is 2 pixels, and so is the half of its width.
constexpr const char* kWorld = R"(
interval_sim 100
camera( name "pair" resolution [4 2] fov [90 53.13010235415598] baseline 0.5 )
camera( name "gray" resolution [4 2] fov [90 53.13010235415598] baseline 0.5 image "gray" )
camera( name "one" resolution [4 2] )
)";

class StereoDevice : public testing::OneDevice {
 protected:
  StereoDevice() : OneDevice(kWorld) {}

  /// What a camera has measured in the next tick.
  void see(world::CameraRow camera, std::vector<float> depths) {
    world::Cameras& cameras = still_.world().cameras;
    cameras.pixels[camera].assign(8, {0x102030});
    cameras.right_pixels[camera].assign(depths.size(), {0x405060});
    cameras.depths[camera] = std::move(depths);
    cameras.measured_tick[camera] = still_.world().tick() + 1;
    still_.run(1);
  }
  std::vector<int> disparities(const wire::camera::Data& data) {
    std::vector<int> values;
    for (std::size_t i = 0; i < data.image.size(); i += 2)
      values.push_back(data.image[i] | data.image[i + 1] << 8);
    return values;
  }
};

TEST_F(StereoDevice, is_of_cameras_with_a_baseline) {
  const world::World& world = still_.world();
  EXPECT_TRUE(fits(world, world.find("pair"), stereo::kCode));
  EXPECT_FALSE(fits(world, world.find("one"), stereo::kCode));
}

TEST_F(StereoDevice, has_pairs_measured_while_it_is_open) {
  world::Cameras& cameras = still_.world().cameras;
  open(stereo::kCode, "pair");
  EXPECT_THAT(cameras.stereo_open, ElementsAre(1, 0, 0));
  driver_.stop(kId);
  still_.run(0);
  EXPECT_THAT(cameras.stereo_open, ElementsAre(0, 0, 0));
}

TEST_F(StereoDevice, tells_sixteenths_of_pixels_and_points_of_what_is_in_range) {
  open(stereo::kCode, "pair");
  see({0}, {1, 2, 0, 4, 1000, 1e-9f, 1, 1});
  const auto data = last<stereo::Data>(stereo::kDataState);
  EXPECT_EQ(data.disparity.fdiv, 16u);
  EXPECT_EQ(data.disparity.format, wire::camera::kFormatMono16);
  EXPECT_EQ(data.disparity.bpp, 16u);
  // 2 px of focal length, and half a metre: 1 px at 1 m.
  EXPECT_THAT(disparities(data.disparity), ElementsAre(16, 8, 0, 4, 0, 65535, 16, 16));
  ASSERT_THAT(data.points, SizeIs(7)) << "one pixel sees nothing";
  EXPECT_EQ(data.points[0].px, 1);
  EXPECT_NEAR(data.points[0].py, 0.75, 1e-6) << "the middle of the leftmost of four pixels";
  EXPECT_NEAR(data.points[0].pz, 0.25, 1e-6) << "and of the upper one of two";
  EXPECT_NEAR(data.points[2].py, -3, 1e-6) << "the rightmost one, at 4 m";
  EXPECT_NEAR(data.points[6].pz, -0.25, 1e-6);
  EXPECT_EQ(data.points[0].red, 0x10);
  EXPECT_EQ(data.points[0].green, 0x20);
  EXPECT_EQ(data.points[0].blue, 0x30);
  EXPECT_EQ(data.left_channel.image[0], 0x10);
  EXPECT_EQ(data.right_channel.image[0], 0x40);
  EXPECT_EQ(data.right_channel.width, 4u);
  EXPECT_EQ(data.right_channel.height, 2u);
}

TEST_F(StereoDevice, has_gray_points_of_gray_images) {
  open(stereo::kCode, "gray");
  see({1}, std::vector<float>(8, 1));
  const auto data = last<stereo::Data>(stereo::kDataState);
  EXPECT_EQ(data.points[0].red, 0x30);
  EXPECT_EQ(data.points[0].green, 0x30);
}

TEST_F(StereoDevice, follows_the_zoom) {
  open(stereo::kCode, "pair");
  still_.world().cameras.zoom[{0}] = 2 * std::atan(0.5);
  see({0}, std::vector<float>(8, 1));
  EXPECT_EQ(disparities(last<stereo::Data>(stereo::kDataState).disparity)[0], 32);
}

TEST_F(StereoDevice, tells_nothing_of_an_image_that_is_none_of_a_pair) {
  open(stereo::kCode, "pair");
  see({0}, {});
  EXPECT_EQ(count(stereo::kDataState), 0);
}

}  // namespace
}  // namespace playhouse::drivers
