#include "playhouse/scene/images/read_png.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "playhouse/scene/images/write_png.h"

namespace playhouse::scene {
namespace {

using testing::HasSubstr;

const std::vector<std::uint8_t> kColors{255, 0, 0, 0,   255, 0,   0,   0,   255,
                                        1,   2, 3, 250, 251, 252, 128, 127, 126};

TEST(ReadRgb, gives_what_was_written) {
  const Result<std::string> png = png_of(3, 2, kColors);
  ASSERT_TRUE(png);
  const Result<RgbImage> image = read_rgb(*png, 6);
  ASSERT_TRUE(image) << image.error().text;
  EXPECT_EQ(image->width, 3);
  EXPECT_EQ(image->height, 2);
  EXPECT_EQ(image->rgb, kColors);
}

TEST(ReadRgb, refuses_what_is_too_large_or_ends_early_or_is_no_png) {
  const Result<std::string> png = png_of(3, 2, kColors);
  ASSERT_TRUE(png);
  EXPECT_THAT(read_rgb(*png, 5).error().text, HasSubstr("has more than 5 pixels"));
  EXPECT_THAT(read_rgb(png->substr(0, png->size() - 20), 6).error().text, HasSubstr("is not a valid PNG"));
  EXPECT_THAT(read_rgb("GIF89a", 6).error().text, HasSubstr("is not a valid PNG"));
  EXPECT_THAT(read_rgb("", 6).error().text, HasSubstr("is not a valid PNG"));
}

}  // namespace
}  // namespace playhouse::scene
