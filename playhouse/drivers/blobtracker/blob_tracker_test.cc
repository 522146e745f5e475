// A camera that turns after blobs, by where these are in its image.

#include "playhouse/drivers/blobtracker/blob_tracker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/drivers/testing/driver_bench.h"
#include "playhouse/wire/generated/dio.h"

namespace playhouse::drivers {
namespace {

namespace blf = wire::blobfinder;
namespace ptz = wire::ptz;

constexpr device::Address kBlobs{6665, blf::kCode, 0}, kCamera{6665, ptz::kCode, 0},
    kFound{6665, wire::dio::kCode, 0};
constexpr std::uint32_t kGreen = 0x00FF00;

blf::Blob blob(std::uint32_t color, std::uint32_t area, std::uint32_t x, std::uint32_t y) {
  blf::Blob made;
  made.color = color;
  made.area = area;
  made.x = x;
  made.y = y;
  return made;
}

blf::Data image_of(std::vector<blf::Blob> blobs) {
  return {100, 50, std::move(blobs)};
}

TEST(BlobOfColor, is_the_largest) {
  const blf::Data image = image_of({blob(kGreen, 5, 1, 1), blob(0xFF0000, 50, 2, 2), blob(kGreen, 9, 3, 3)});
  EXPECT_EQ(blob_of_color(image, kGreen)->x, 3u);
  EXPECT_EQ(blob_of_color(image, 0x0000FF), nullptr);
}

TEST(TurnTowards, is_a_step_to_the_side_of_the_blob) {
  BlobTrackerOptions options;
  options.step = 0.1;
  const ptz::Data looks{0.5f, 0.25f, 1, 0, 0, 0};
  const auto told = [&](std::uint32_t x, std::uint32_t y) {
    return turn_towards(options, image_of({}), blob(kGreen, 1, x, y), looks);
  };
  EXPECT_FALSE(told(50, 25));
  EXPECT_FALSE(told(69, 16)) << "0.4 of the image is its middle";
  EXPECT_FLOAT_EQ(told(71, 25)->pan, 0.4f) << "to the right";
  EXPECT_FLOAT_EQ(told(71, 25)->tilt, 0.25f);
  EXPECT_FLOAT_EQ(told(29, 14)->pan, 0.6f);
  EXPECT_FLOAT_EQ(told(29, 14)->tilt, 0.35f) << "up";
  EXPECT_EQ(told(29, 14)->zoom, 1);
  options.zoom = 0.75;
  EXPECT_EQ(told(29, 14)->zoom, 0.75f);
  EXPECT_FALSE(turn_towards(options, {}, blob(kGreen, 1, 9, 9), looks)) << "an image without pixels";
}

TEST(BlobTracker, tells_whether_it_sees_one_and_turns_the_camera) {
  testing::DriverBench bench(
      "driver( name \"blobtracker\" provides [\"dio:0\"] requires [\"blobfinder:0\" \"ptz:0\"] g 255 step 2 "
      ")",
      {kBlobs, kCamera}, kFound);
  const auto see = [&bench](const blf::Data& image) {
    bench.says(kBlobs, blf::kDataBlobs, 1, image);
    return bench.heard<wire::dio::Data>(wire::dio::kDataValues).at(0).bits;
  };
  EXPECT_EQ(see(image_of({blob(kGreen, 1, 99, 25)})), 1u);
  EXPECT_TRUE(bench.told().commands.empty()) << "it does not know where the camera looks";
  bench.says(kCamera, ptz::kDataState, 1, ptz::Data{});
  EXPECT_EQ(see(image_of({blob(0xFF0000, 1, 99, 25)})), 0u);
  EXPECT_TRUE(bench.told().commands.empty());
  EXPECT_EQ(see(image_of({blob(kGreen, 1, 99, 25)})), 1u);
  EXPECT_FLOAT_EQ(bench.commanded<ptz::Cmd>(kCamera, ptz::kCmdState).at(0).pan,
                  static_cast<float>(geom::radians(-2)));
}

TEST(BlobTracker, says_what_is_wrong_with_its_options) {
  const auto fault = [](const std::string& options) {
    return testing::fault_of(
        "driver( name \"dummy\" provides [\"blobfinder:0\" \"ptz:0\"] )\n"
        "driver( name \"blobtracker\" provides [\"dio:0\"] requires [\"blobfinder:0\" \"ptz:0\"] " +
        options + " )");
  };
  EXPECT_EQ(fault("r 256"), "test.cfg:2: r is from 0 to 255");
  EXPECT_EQ(fault("idle_area 1.5"), "test.cfg:2: idle_area is from 0 to 1");
}

}  // namespace
}  // namespace playhouse::drivers
