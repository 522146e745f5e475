#include "playhouse/scene/images/bitmap.h"

#include <algorithm>

#include "playhouse/images/read_image.h"
#include "playhouse/mesh/import/trimmed.h"

namespace playhouse::scene {
namespace {

constexpr std::uint8_t kSolidUpTo = 127;

/// A corner of the pixel grid in image coordinates: y down from the top edge.
struct Corner {
  int x, y;
  friend bool operator==(Corner, Corner) = default;
};

enum Heading { kEast, kNorth, kWest, kSouth };  // counter-clockwise, so that +1 turns left
constexpr Corner kStep[] = {{1, 0}, {0, -1}, {-1, 0}, {0, 1}};

/// The pixels ahead of a corner, to the left and right of the direction of travel.
Corner left_ahead(Corner c, Heading h) {
  constexpr Corner kOffset[] = {{0, -1}, {-1, -1}, {-1, 0}, {0, 0}};
  return {c.x + kOffset[h].x, c.y + kOffset[h].y};
}
Corner right_ahead(Corner c, Heading h) {
  return left_ahead(c, static_cast<Heading>((h + 3) % 4));
}

/// Next direction at a corner, with solid on the left; where two solid
/// pixels meet diagonally it turns left, around the present one.
Heading turn(const Bitmap& bitmap, Corner c, Heading h) {
  const Corner left = left_ahead(c, h), right = right_ahead(c, h);
  if (!bitmap.at(left.x, left.y)) return static_cast<Heading>((h + 1) % 4);
  return bitmap.at(right.x, right.y) ? static_cast<Heading>((h + 3) % 4) : h;
}

/// Traces one contour from the top edge of the solid pixel
/// (x, y), westward, and marks the top edges it passes.
std::vector<geom::Vec2> walk(const Bitmap& bitmap, int x, int y, std::vector<bool>& seen) {
  const Corner start{x + 1, y};
  std::vector<geom::Vec2> loop;
  Corner c = start;
  Heading h = kWest;
  do {
    if (h == kWest) {
      seen[static_cast<std::size_t>(c.y) * static_cast<std::size_t>(bitmap.width) +
           static_cast<std::size_t>(c.x - 1)] = true;
    }
    c = {c.x + kStep[h].x, c.y + kStep[h].y};
    const Heading next = turn(bitmap, c, h);
    if (next != h) loop.push_back({static_cast<double>(c.x), static_cast<double>(bitmap.height - c.y)});
    h = next;
  } while (!(c == start && h == kWest));
  return loop;
}

}  // namespace

Result<Bitmap> decode_bitmap(std::string_view bytes, std::size_t most_pixels) {
  Result<images::FirstChannel> image = images::read_image<images::FirstChannel>(bytes, {most_pixels});
  if (!image) return image.error();
  Bitmap bitmap{image->width, image->height, std::move(image->level)};
  for (std::uint8_t& pixel : bitmap.solid) pixel = pixel <= kSolidUpTo ? 1 : 0;
  return bitmap;
}

bool is_image_name(std::string_view name) {
  constexpr std::string_view kEndings[] = {".png", ".jpg", ".jpeg", ".pgm", ".ppm", ".pbm", ".pnm", ".bmp"};
  const std::string small = mesh::lower(name);
  return std::ranges::any_of(kEndings, [&small](std::string_view ending) { return small.ends_with(ending); });
}

Result<std::vector<std::vector<geom::Vec2>>> trace_contours(const Bitmap& bitmap, std::size_t most_corners) {
  // Every contour has an edge with solid below and free above, so scanning for those finds them all.
  std::vector<std::vector<geom::Vec2>> loops;
  std::vector<bool> seen(bitmap.solid.size());
  std::size_t pixel = 0, corners = 0;
  for (int y = 0; y < bitmap.height; ++y) {
    for (int x = 0; x < bitmap.width; ++x, ++pixel) {
      if (!bitmap.solid[pixel] || seen[pixel] || bitmap.at(x, y - 1)) continue;
      loops.push_back(walk(bitmap, x, y, seen));
      corners += loops.back().size();
      if (corners > most_corners)
        return Error{"", "has outlines of more than " + std::to_string(most_corners) + " corners"};
    }
  }
  return loops;
}

}  // namespace playhouse::scene
