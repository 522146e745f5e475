/// Any bytes as an image: decodes to pixels whose contours enclose as much as is solid, and to colors that are
/// the same once they are written and read again, or fails with a text.
/// A PNG is read a second time with the checksums of its chunks mended, or hardly one would get past them.

#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <string>

#include "playhouse/base/assert.h"
#include "playhouse/images/read_image.h"
#include "playhouse/images/write_png.h"
#include "playhouse/scene/images/bitmap.h"

namespace playhouse::scene {
namespace {

constexpr std::size_t kPixels = 1 << 16, kCorners = 1 << 18;

double enclosed(const std::vector<std::vector<geom::Vec2>>& loops) {
  double twice = 0;
  for (const std::vector<geom::Vec2>& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) twice += geom::cross(loop[i], loop[(i + 1) % loop.size()]);
  return twice / 2;
}

void expect_pixels_or_text(const std::string& image) {
  const Result<Bitmap> bitmap = decode_bitmap(image, kPixels);
  if (!bitmap) return PLAYHOUSE_ASSERT(!bitmap.error().text.empty());
  const auto width = static_cast<std::size_t>(bitmap->width),
             height = static_cast<std::size_t>(bitmap->height);
  PLAYHOUSE_ASSERT(width > 0 && height > 0 && bitmap->solid.size() == width * height);
  PLAYHOUSE_ASSERT(bitmap->solid.size() <= kPixels);
  double solid = 0;
  for (const std::uint8_t pixel : bitmap->solid) {
    PLAYHOUSE_ASSERT(pixel <= 1);
    solid += pixel;
  }
  const auto loops = trace_contours(*bitmap, kCorners);
  PLAYHOUSE_ASSERT(loops ? enclosed(*loops) == solid : !loops.error().text.empty());
}

void expect_colors_or_text(const std::string& image) {
  const auto colors = images::read_image<images::RgbaImage>(image, {kPixels});
  if (!colors) return PLAYHOUSE_ASSERT(!colors.error().text.empty());
  PLAYHOUSE_ASSERT(colors->rgba.size() <= 4 * kPixels);
  const auto png = images::png_of(colors->width, colors->height, 4, colors->rgba, images::PngEffort::kFast);
  const auto again = images::read_image<images::RgbaImage>(*png, {kPixels});
  PLAYHOUSE_ASSERT(again && again->rgba == colors->rgba);
}

/// Length, kind, content, checksum; as many as there are whole.
void mend_checksums(std::string& png) {
  constexpr std::size_t kSignature = 8, kLength = 4, kKind = 4, kSum = 4;
  const auto byte = [&](std::size_t at) { return static_cast<std::uint8_t>(png[at]); };
  for (std::size_t at = kSignature; at + kLength + kKind + kSum <= png.size();) {
    const std::size_t length = std::size_t{byte(at)} << 24 | std::size_t{byte(at + 1)} << 16 |
                               std::size_t{byte(at + 2)} << 8 | byte(at + 3);
    if (length > png.size() - at - kLength - kKind - kSum) return;
    at += kLength;
    const auto* content = reinterpret_cast<const Bytef*>(png.data() + at);
    const uLong sum = crc32(0, content, static_cast<uInt>(kKind + length));
    at += kKind + length;
    for (int shift = 24; shift >= 0; shift -= 8) png[at++] = static_cast<char>(sum >> shift & 0xFF);
  }
}

}  // namespace
}  // namespace playhouse::scene

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace playhouse::scene;
  std::string image(reinterpret_cast<const char*>(bytes), size);
  expect_pixels_or_text(image);
  expect_colors_or_text(image);
  if (!image.starts_with("\x89PNG")) return 0;
  mend_checksums(image);
  expect_pixels_or_text(image);
  expect_colors_or_text(image);
  return 0;
}
