// What was written comes back, in each of the forms. Formats and damaged files: scene/images/bitmap_test.cc.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include <string>

#include "playhouse/images/read_image.h"
#include "playhouse/images/write_png.h"

namespace playhouse::images {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::vector<std::uint8_t> kColors{255, 0, 0, 0,   255, 0,   0,   0,   255,
                                        1,   2, 3, 250, 251, 252, 128, 127, 126};

TEST(ReadImage, gives_what_was_written) {
  const Result<std::string> png = png_of(3, 2, 3, kColors);
  ASSERT_TRUE(png);
  const Result<RgbImage> image = read_image<RgbImage>(*png, {6});
  ASSERT_TRUE(image) << image.error().text;
  EXPECT_EQ(image->width, 3);
  EXPECT_EQ(image->height, 2);
  EXPECT_EQ(image->rgb, kColors);
}

TEST(ReadImage, alpha_is_kept_or_lets_black_through) {
  const std::vector<std::uint8_t> pixels{200, 100, 50, 128, 9, 8, 7, 255, 1, 2, 3, 0};
  for (const PngEffort effort : {PngEffort::kSmall, PngEffort::kFast}) {
    const Result<std::string> png = png_of(3, 1, 4, pixels, effort);
    ASSERT_TRUE(png);
    EXPECT_EQ(read_image<RgbaImage>(*png, {3})->rgba, pixels);
    EXPECT_THAT(read_image<RgbImage>(*png, {3})->rgb, ElementsAre(100, 50, 25, 9, 8, 7, 0, 0, 0));
    EXPECT_THAT(read_image<FirstChannel>(*png, {3})->level, ElementsAre(200, 9, 255));
    EXPECT_THAT(read_image<Shades>(*png, {3})->color, ElementsAre(350, 24, 6));
    EXPECT_THAT(read_image<Shades>(*png, {3})->alpha, ElementsAre(128, 255, 0));
  }
}

TEST(ReadImage, gray_is_a_color_without_alpha) {
  const Result<RgbaImage> image = read_image<RgbaImage>("P5 2 1 255\n\x07\xF0", {2});
  ASSERT_TRUE(image) << image.error().text;
  EXPECT_THAT(image->rgba, ElementsAre(7, 7, 7, 255, 240, 240, 240, 255));
}

/// As glTF demands of textures.
TEST(ReadImage, takes_samples_as_they_are_whatever_gamma_the_file_names) {
  std::string file;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop about = png_create_info_struct(png);
  png_set_write_fn(
      png, &file,
      [](png_structp to, png_bytep bytes, std::size_t count) {
        static_cast<std::string*>(png_get_io_ptr(to))->append(reinterpret_cast<char*>(bytes), count);
      },
      nullptr);
  png_set_IHDR(png, about, 1, 1, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_set_gAMA(png, about, 1.0);
  png_write_info(png, about);
  const png_byte row[] = {10, 20, 30};
  png_write_row(png, row);
  png_write_end(png, about);
  png_destroy_write_struct(&png, &about);
  EXPECT_THAT(read_image<RgbaImage>(file, {1})->rgba, ElementsAre(10, 20, 30, 255));
}

TEST(ReadImage, refuses_what_is_too_large_or_ends_early_or_is_no_image) {
  const Result<std::string> png = png_of(3, 2, 3, kColors);
  ASSERT_TRUE(png);
  const auto fault = [](std::string_view bytes, const ImageLimits& most) {
    return read_image<RgbImage>(bytes, most).error().text;
  };
  EXPECT_EQ(fault(*png, {5}), "has 3 x 2 pixels; up to 5 are possible");
  EXPECT_EQ(fault(*png, {6, 2}), "has 3 x 2 pixels; up to 2 a side are possible");
  EXPECT_THAT(fault(png->substr(0, png->size() - 20), {6}), HasSubstr("is not a valid PNG"));
  EXPECT_THAT(fault("GIF89a", {6}), HasSubstr("is not a PNG, JPEG, PNM"));
  EXPECT_THAT(fault("", {6}), HasSubstr("is not a PNG, JPEG, PNM"));
}

}  // namespace
}  // namespace playhouse::images
