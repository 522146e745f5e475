#include "playhouse/scene/images/bitmap.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>
#include <rapidcheck/gtest.h>
#include <turbojpeg.h>

#include <optional>
#include <string>

namespace playhouse::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A bitmap drawn in text, "#" solid, rows from the top.
Bitmap drawn(const std::vector<std::string>& rows) {
  Bitmap bitmap{static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), {}};
  for (const std::string& row : rows) {
    for (const char c : row) bitmap.solid.push_back(c == '#' ? 1 : 0);
  }
  return bitmap;
}

std::vector<std::uint8_t> solid_of(std::string_view bytes) {
  const Result<Bitmap> bitmap = decode_bitmap(bytes);
  EXPECT_TRUE(bitmap.ok()) << bitmap.error().line();
  return bitmap ? bitmap->solid : std::vector<std::uint8_t>{};
}

std::string png_of(std::uint32_t width, std::uint32_t height, std::uint32_t format,
                   const std::string& pixels) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = width;
  image.height = height;
  image.format = format;
  png_alloc_size_t size = 0;
  EXPECT_TRUE(png_image_write_to_memory(&image, nullptr, &size, 0, pixels.data(), 0, nullptr));
  std::string bytes(size, '\0');
  EXPECT_TRUE(png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr));
  return bytes;
}

TEST(Bitmap, a_pixel_is_solid_up_to_half_of_its_first_channel) {
  EXPECT_THAT(solid_of(png_of(4, 1, PNG_FORMAT_GRAY, std::string("\0\x7f\x80\xff", 4))),
              ElementsAre(1, 1, 0, 0));
  // Red is free, cyan is solid, and so is neither of what is mostly transparent.
  EXPECT_THAT(solid_of(png_of(2, 1, PNG_FORMAT_RGB, std::string("\xff\0\0\0\xff\xff", 6))),
              ElementsAre(0, 1));
  EXPECT_THAT(solid_of(png_of(2, 1, PNG_FORMAT_RGBA, std::string("\0\0\0\0\xff\xff\xff\0", 8))),
              ElementsAre(0, 0));
  EXPECT_THAT(solid_of(png_of(2, 1, PNG_FORMAT_RGBA, std::string("\0\0\0\x7f\0\0\0\x80", 8))),
              ElementsAre(0, 1));
  EXPECT_THAT(solid_of(png_of(2, 1, PNG_FORMAT_GA, std::string("\0\x7f\0\x80", 4))), ElementsAre(0, 1));
}

/// Of one color, red or gray.
std::string jpeg_of(int width, int height, std::uint8_t red, int sampling) {
  std::string pixels;
  for (int i = 0; i < width * height; ++i) pixels += {static_cast<char>(red), '\0', '\0'};
  const tjhandle library = tjInitCompress();
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  EXPECT_EQ(tjCompress2(library, reinterpret_cast<const unsigned char*>(pixels.data()), width, 0, height,
                        TJPF_RGB, &bytes, &size, sampling, 95, 0),
            0);
  std::string image(reinterpret_cast<const char*>(bytes), size);
  tjFree(bytes);
  tjDestroy(library);
  return image;
}

TEST(Bitmap, a_jpeg_is_read) {
  EXPECT_THAT(solid_of(jpeg_of(3, 2, 200, TJSAMP_444)), testing::AllOf(testing::SizeIs(6), testing::Each(0)));
  EXPECT_THAT(solid_of(jpeg_of(3, 2, 60, TJSAMP_420)), testing::AllOf(testing::SizeIs(6), testing::Each(1)));
  EXPECT_THAT(solid_of(jpeg_of(3, 2, 200, TJSAMP_GRAY)), testing::Each(1)) << "its brightness is 60";
}

TEST(Bitmap, a_jpeg_that_ends_before_its_last_pixel_is_no_image) {
  const std::string whole = jpeg_of(64, 64, 0, TJSAMP_444);
  EXPECT_FALSE(decode_bitmap(whole.substr(0, 3)));
  for (const std::size_t bytes : {whole.size() / 4, whole.size() - 20}) {
    const Result<Bitmap> bitmap = decode_bitmap(whole.substr(0, bytes));
    ASSERT_FALSE(bitmap) << bytes;
    EXPECT_THAT(bitmap.error().text, HasSubstr("is not a valid JPEG: ")) << bytes;
  }
  std::string wide = whole;  // whose header promises 16384 x 16384
  const std::size_t frame = wide.find(std::string("\xFF\xC0", 2));
  ASSERT_NE(frame, std::string::npos);
  wide.replace(frame + 5, 4, std::string("\x40\0\x40\0", 4));
  EXPECT_EQ(decode_bitmap(wide).error().text, "is not a valid JPEG: the file ends too early");
  const Result<Bitmap> large = decode_bitmap(whole, 1000);
  ASSERT_FALSE(large);
  EXPECT_THAT(large.error().text, HasSubstr("64 x 64 pixels; up to 1000"));
}

TEST(Bitmap, is_known_by_its_name) {
  for (const char* name : {"a.png", "a.b/plan.JPG", "a.jpeg", "a.pgm", "a.PBM", "a.bmp"})
    EXPECT_TRUE(is_image_name(name)) << name;
  for (const char* name : {"a.gif", "a.tif", "a.world", "png", "", "a.png.world"})
    EXPECT_FALSE(is_image_name(name)) << name;
}

TEST(Bitmap, all_kinds_of_pnm_are_read) {
  EXPECT_THAT(solid_of("P1\n# note\n2 2\n10\n0 1\n"), ElementsAre(1, 0, 0, 1));
  EXPECT_THAT(solid_of("P2 3 1 15 0 7 8"), ElementsAre(1, 1, 0)) << "7 of 15 is 119 of 255, 8 is 136";
  EXPECT_THAT(solid_of("P3 2 1 255 255 0 0 0 255 255"), ElementsAre(0, 1));
  EXPECT_THAT(solid_of(std::string("P4\n9 2\n\x80\x80\x00\x80", 12)),
              ElementsAre(1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1));
  EXPECT_THAT(solid_of(std::string("P5\n2 1\n255\n\x10\xf0", 13)), ElementsAre(1, 0));
  EXPECT_THAT(solid_of(std::string("P5\n2 1\n1000\n\x01\xe0\x03\xe8", 16)), ElementsAre(1, 0))
      << "480 of 1000 is 122";
  EXPECT_THAT(solid_of(std::string("P6\n2 1\n255\n\xff\0\0\0\xff\xff", 17)), ElementsAre(0, 1));
}

TEST(Bitmap, a_bmp_is_read) {
  std::string bmp("BM\x3a\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\x01\0\0\0\x01\0\0\0\x01\0\x18\0", 30);
  bmp.resize(54, '\0');
  bmp += std::string("\0\0\xff\0", 4);  // one red pixel, blue first
  EXPECT_THAT(solid_of(bmp), ElementsAre(0));
}

/// A BMP without palette, `depth` bits a pixel, all zero.
std::string bmp_of(int width, int height, int depth, std::optional<int> told_height = {}) {
  const int row = (width * depth + 31) / 32 * 4;
  std::string bmp("BM\0\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0", 18);
  const auto number = [&bmp](int value, int bytes) {
    for (int i = 0; i < bytes; ++i) bmp += static_cast<char>(value >> (8 * i) & 255);
  };
  number(width, 4);
  number(told_height.value_or(height), 4);
  number(1, 2);
  number(depth, 2);
  bmp.resize(54 + static_cast<std::size_t>(row * height), '\0');
  return bmp;
}

TEST(Bitmap, a_bmp_that_ends_before_its_last_pixel_is_no_image) {
  const std::string whole = bmp_of(5, 40, 24);  // 15 bytes of pixels and a pad of 1 in a row
  EXPECT_EQ(solid_of(whole).size(), 200u);
  EXPECT_EQ(solid_of(whole.substr(0, whole.size() - 1)).size(), 200u) << "padding is no pixel";
  for (const std::size_t bytes : {whole.size() - 2, whole.size() - 16, whole.size() / 2, std::size_t{54}}) {
    const Result<Bitmap> bitmap = decode_bitmap(whole.substr(0, bytes));
    ASSERT_FALSE(bitmap) << bytes;
    EXPECT_EQ(bitmap.error().text, "is not a valid BMP: the file ends too early") << bytes;
  }
}

TEST(Bitmap, a_bmp_may_have_its_rows_from_the_top_to_the_bottom) {
  EXPECT_EQ(solid_of(bmp_of(5, 40, 24, -40)).size(), 200u);
}

TEST(Bitmap, what_is_no_image_says_so) {
  const auto error = [](std::string_view bytes) {
    const Result<Bitmap> bitmap = decode_bitmap(bytes, 1000);
    return bitmap ? "no error" : bitmap.error().line();
  };
  EXPECT_THAT(error(""), HasSubstr("is not a PNG, JPEG, PNM"));
  EXPECT_THAT(error("GIF89a"), HasSubstr("is not a PNG, JPEG, PNM (.pgm, .ppm, .pbm) or BMP image"));
  EXPECT_THAT(error("hello"), HasSubstr("is not a PNG, JPEG, PNM"));
  EXPECT_THAT(error("P1 3 3 1 1"), HasSubstr("end too early"));
  EXPECT_THAT(error("P2 1 1 255 256"), HasSubstr("not a valid PNM"));
  EXPECT_THAT(error("P5 2 2 255 \x01\x02"), HasSubstr("end too early"));
  EXPECT_THAT(error("P5 88888888888888888 1 255 1"), HasSubstr("pixels; up to 1000"));
  EXPECT_THAT(error("P4 99999 99999 "), HasSubstr("99999 x 99999 pixels; up to 1000"));
  const std::string png = png_of(4, 4, PNG_FORMAT_GRAY, std::string(16, '\0'));
  EXPECT_THAT(error(png.substr(0, png.size() / 2)), HasSubstr("is not a valid PNG"));
  EXPECT_THAT(error(png_of(40, 40, PNG_FORMAT_GRAY, std::string(1600, '\0'))), HasSubstr("40 x 40 pixels"));
}

TEST(Contours, a_square_is_four_corners_counter_clockwise) {
  const auto loops = *trace_contours(drawn({"....", ".##.", ".##.", "...."}));
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_THAT(loops[0], ElementsAre(geom::Vec2{1, 3}, geom::Vec2{1, 1}, geom::Vec2{3, 1}, geom::Vec2{3, 3}));
}

TEST(Contours, a_hole_is_a_second_loop_the_other_way_round) {
  const auto loops = *trace_contours(drawn({"###", "#.#", "###"}));
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_THAT(loops[1], testing::UnorderedElementsAre(geom::Vec2{1, 1}, geom::Vec2{1, 2}, geom::Vec2{2, 2},
                                                      geom::Vec2{2, 1}));
  double area[2] = {};
  for (std::size_t l = 0; l < 2; ++l) {
    for (std::size_t i = 0; i < 4; ++i) area[l] += cross(loops[l][i], loops[l][(i + 1) % 4]) / 2;
  }
  EXPECT_EQ(area[0], 9);
  EXPECT_EQ(area[1], -1);
}

TEST(Contours, pixels_that_touch_at_a_corner_are_apart) {
  EXPECT_EQ(trace_contours(drawn({"#.", ".#"}))->size(), 2u);
  EXPECT_EQ(trace_contours(drawn({".#", "#."}))->size(), 2u);
  EXPECT_TRUE(trace_contours(drawn({".."}))->empty());
}

TEST(Contours, more_corners_than_allowed_are_a_fault_before_they_cost_memory) {
  const Bitmap four_corners_each = drawn({"#.#", ".#.", "#.#"});
  EXPECT_TRUE(trace_contours(four_corners_each, 20));
  const auto refused = trace_contours(four_corners_each, 19);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().text, "has outlines of more than 19 corners");
}

/// Oracle: crossings of a ray to the right from the pixel's centre with the vertical edges of all loops.
bool inside(const std::vector<std::vector<geom::Vec2>>& loops, geom::Vec2 p) {
  bool odd = false;
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const geom::Vec2 a = loop[i], b = loop[(i + 1) % loop.size()];
      if (a.x == b.x && a.x > p.x && (a.y > p.y) != (b.y > p.y)) odd = !odd;
    }
  }
  return odd;
}

RC_GTEST_PROP(Contours, filled_again_by_the_even_odd_rule_they_are_the_bitmap, ()) {
  const int width = *rc::gen::inRange(1, 14), height = *rc::gen::inRange(1, 14);
  Bitmap bitmap{width, height, {}};
  const auto cells = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  bitmap.solid = *rc::gen::container<std::vector<std::uint8_t>>(
      cells, rc::gen::weightedElement<std::uint8_t>({{3, 0}, {4, 1}}));
  const auto loops = *trace_contours(bitmap);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) RC_ASSERT(inside(loops, {x + 0.5, height - y - 0.5}) == bitmap.at(x, y));
  }
  double area = 0;
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const geom::Vec2 a = loop[i], b = loop[(i + 1) % loop.size()], c = loop[(i + 2) % loop.size()];
      area += cross(a, b) / 2;
      RC_ASSERT((a.x == b.x) != (a.y == b.y));
      RC_ASSERT((a.x == b.x) != (b.x == c.x));  // collinear runs are merged
    }
  }
  RC_ASSERT(area == static_cast<double>(std::count(bitmap.solid.begin(), bitmap.solid.end(), 1)));
}

}  // namespace
}  // namespace playhouse::scene
