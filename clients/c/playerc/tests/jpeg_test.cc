// Compressed images of a camera proxy.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <cstdlib>
#include <cstring>
#include <vector>

#include "libplayerc/playerc.h"

namespace {

using testing::HasSubstr;

constexpr int kWidth = 40, kHeight = 24;

/** The left half red, the right one blue. */
std::vector<unsigned char> half_and_half() {
  std::vector<unsigned char> pixels(kWidth * kHeight * 3);
  for (std::size_t i = 0; i < pixels.size() / 3; ++i) pixels[i * 3 + (i % kWidth < kWidth / 2 ? 0 : 2)] = 250;
  return pixels;
}

std::vector<unsigned char> jpeg_of(const std::vector<unsigned char> &pixels, int flags = 0) {
  const tjhandle writer = tjInitCompress();
  unsigned char *bytes = nullptr;
  unsigned long size = 0;
  EXPECT_EQ(
      tjCompress2(writer, pixels.data(), kWidth, 0, kHeight, TJPF_RGB, &bytes, &size, TJSAMP_444, 95, flags),
      0);
  const std::vector<unsigned char> jpeg(bytes, bytes + size);
  tjFree(bytes);
  tjDestroy(writer);
  return jpeg;
}

class Jpeg : public testing::Test {
 protected:
  ~Jpeg() override {
    playerc_camera_destroy(camera);
    playerc_client_destroy(client);
  }
  /** As after data of a camera. */
  void put(const std::vector<unsigned char> &image, int compression) {
    camera->width = kWidth;
    camera->height = kHeight;
    camera->bpp = 24;
    camera->format = PLAYER_CAMERA_FORMAT_RGB888;
    camera->compression = compression;
    camera->image_count = static_cast<int>(image.size());
    camera->image = static_cast<uint8_t *>(std::malloc(image.size() + 1));
    std::memcpy(camera->image, image.data(), image.size());
  }
  unsigned part(unsigned x, unsigned y, int component) {
    return playerc_camera_get_pixel_component(camera, x, y, component);
  }

  playerc_client_t *client = playerc_client_create(nullptr, "localhost", 1);
  playerc_camera_t *camera = playerc_camera_create(client, 0);
};

TEST_F(Jpeg, BecomesPixels) {
  put(jpeg_of(half_and_half()), PLAYER_CAMERA_COMPRESS_JPEG);
  EXPECT_EQ(part(0, 0, 0), 0U) << "not before";
  playerc_camera_decompress(camera);
  EXPECT_EQ(camera->compression, PLAYER_CAMERA_COMPRESS_RAW);
  ASSERT_EQ(camera->image_count, kWidth * kHeight * 3);
  EXPECT_NEAR(part(2, 20, 0), 250, 8);
  EXPECT_NEAR(part(2, 20, 2), 0, 8);
  EXPECT_NEAR(part(kWidth - 2, 1, 2), 250, 8);
  playerc_camera_decompress(camera);
  EXPECT_NEAR(part(2, 20, 0), 250, 8) << "a second time changes nothing";
}

TEST_F(Jpeg, ThatIsNoneIsToldAndRemains) {
  put({1, 2, 3, 4}, PLAYER_CAMERA_COMPRESS_JPEG);
  playerc_camera_decompress(camera);
  EXPECT_THAT(playerc_error_str(), HasSubstr("the image is no JPEG"));
  EXPECT_EQ(camera->compression, PLAYER_CAMERA_COMPRESS_JPEG);
  EXPECT_EQ(camera->image_count, 4);
}

TEST_F(Jpeg, ThatIsCutOffIsShownAsFarAsItGoes) {
  std::vector<unsigned char> jpeg = jpeg_of(half_and_half());
  jpeg.resize(jpeg.size() - 20);
  put(jpeg, PLAYER_CAMERA_COMPRESS_JPEG);
  playerc_camera_decompress(camera);
  EXPECT_NEAR(part(2, 1, 0), 250, 8);
}

TEST_F(Jpeg, ThatClaimsToBeHugeTakesNoMemory) {
  std::vector<unsigned char> jpeg = jpeg_of(half_and_half());
  for (std::size_t i = 0; i + 8 < jpeg.size(); ++i) {
    if (jpeg[i] == 0xFF && jpeg[i + 1] == 0xC0) std::memset(&jpeg[i + 5], 0xF0, 4);  // height and width
  }
  put(jpeg, PLAYER_CAMERA_COMPRESS_JPEG);
  playerc_camera_decompress(camera);
  EXPECT_THAT(playerc_error_str(), HasSubstr("61680 x 61680 pixels is too large"));
}

/** Its last scan again and again, each of which takes a moment for a few bytes. */
TEST_F(Jpeg, OfThousandsOfScansIsRefused) {
  std::vector<unsigned char> jpeg = jpeg_of(half_and_half(), TJFLAG_PROGRESSIVE);
  std::size_t last = 0;
  for (std::size_t i = 0; i + 1 < jpeg.size(); ++i) {
    if (jpeg[i] == 0xFF && jpeg[i + 1] == 0xDA) last = i;
  }
  ASSERT_GT(last, 0U);
  const std::vector<unsigned char> scan(jpeg.begin() + static_cast<long>(last), jpeg.end() - 2);
  const std::vector<unsigned char> end(jpeg.end() - 2, jpeg.end());
  jpeg.resize(jpeg.size() - 2);
  for (int i = 0; i < 2000; ++i) jpeg.insert(jpeg.end(), scan.begin(), scan.end());
  jpeg.insert(jpeg.end(), end.begin(), end.end());
  put(jpeg, PLAYER_CAMERA_COMPRESS_JPEG);
  playerc_camera_decompress(camera);
  EXPECT_THAT(playerc_error_str(), HasSubstr("the image is no JPEG that can be read"));
  EXPECT_EQ(camera->compression, PLAYER_CAMERA_COMPRESS_JPEG);
}

TEST_F(Jpeg, AnotherCompressionIsTold) {
  put({1}, 7);
  playerc_camera_decompress(camera);
  EXPECT_THAT(playerc_error_str(), HasSubstr("no compression that is known: 7"));
}

}  // namespace
