#include "playhouse/scene/images/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "playhouse/base/in_quotes.h"
#include "playhouse/scene/properties.h"

namespace playhouse::scene {
namespace {

/// A pixel rectangle from the lower left, half-open.
struct Extent {
  int x0, y0, x1, y1;
};

std::optional<Extent> extent_of(const Bitmap& solid) {
  Extent all{solid.width, solid.height, 0, 0};
  for (int row = 0; row < solid.height; ++row)
    for (int x = 0; x < solid.width; ++x) {
      if (!solid.at(x, row)) continue;
      const int y = solid.height - 1 - row;
      all = {std::min(all.x0, x), std::min(all.y0, y), std::max(all.x1, x + 1), std::max(all.y1, y + 1)};
    }
  if (all.x1 == 0) return std::nullopt;
  return all;
}

/// Free space around each pixel: the largest free square centred on
/// it, 0 if it is not free. Two-pass chessboard distance transform.
std::vector<int> room_of(const Bitmap& free) {
  const int w = free.width, h = free.height;
  std::vector<int> room(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
  const auto at = [&](int x, int y) {
    return x < 0 || y < 0 || x >= w || y >= h
               ? 0
               : room[static_cast<std::size_t>(y) * static_cast<std::size_t>(w) +
                      static_cast<std::size_t>(x)];
  };
  const auto pass = [&](int x, int y, int side) {
    if (!free.at(x, y)) return;
    int& here = room[static_cast<std::size_t>(y) * static_cast<std::size_t>(w) + static_cast<std::size_t>(x)];
    const int near = std::min(std::min(at(x - side, y), at(x, y - side)),
                              std::min(at(x - 1, y - side), at(x + 1, y - side)));
    here = side > 0 ? near + 1 : std::min(here, near + 1);
  };
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) pass(x, y, 1);
  for (int y = h - 1; y >= 0; --y)
    for (int x = w - 1; x >= 0; --x) pass(x, y, -1);
  return room;
}

constexpr double kRobotSize = 0.4;         // m
constexpr double kLeastResolution = 1e-5;  // m; world files have micrometre resolution

/// Pixels of a plan, row by row from the top, as an image.
class Region {
 public:
  /// The pixels of which `holds` is true, by their rows.
  template <typename Holds>
  Region(const Bitmap& like, const Holds& holds)
      : width_(static_cast<std::size_t>(like.width)), in_(width_ * static_cast<std::size_t>(like.height)) {
    for (std::size_t i = 0; i < in_.size(); ++i) in_[i] = holds(i);
  }

  bool has(std::size_t pixel) const { return in_[pixel] != 0; }

  /// Its largest part that is connected, by edges of pixels; only pixels within the walls count, so that what
  /// is around a building does not count. Of equal ones the first. Empty if the region is.
  Region largest_part(const Extent& walls) const {
    std::vector<std::uint32_t> part(in_.size(), 0);  // from 1; 0: none
    std::uint32_t parts = 0, best = 0;
    std::size_t most = 0;
    for (std::size_t i = 0; i < in_.size(); ++i) {
      if (!has(i) || part[i] != 0) continue;
      const std::size_t size = fill(i, ++parts, walls, part);
      if (best != 0 && size <= most) continue;
      best = parts;
      most = size;
    }
    Region largest = *this;
    for (std::size_t i = 0; i < in_.size(); ++i) largest.in_[i] = best != 0 && part[i] == best;
    return largest;
  }

 private:
  /// Marks the part with this pixel; returns its number of pixels within the walls.
  std::size_t fill(std::size_t from, std::uint32_t number, const Extent& walls,
                   std::vector<std::uint32_t>& part) const {
    std::vector<std::size_t> open{from};
    part[from] = number;
    std::size_t inside = 0;
    const auto reach = [&](std::size_t pixel) {
      if (!has(pixel) || part[pixel] != 0) return;
      part[pixel] = number;
      open.push_back(pixel);
    };
    const std::size_t height = in_.size() / width_;
    while (!open.empty()) {
      const std::size_t pixel = open.back(), x = pixel % width_, row = pixel / width_;
      open.pop_back();
      const int px = static_cast<int>(x), py = static_cast<int>(height - 1 - row);
      inside += px >= walls.x0 && px < walls.x1 && py >= walls.y0 && py < walls.y1;
      if (x > 0) reach(pixel - 1);
      if (x + 1 < width_) reach(pixel + 1);
      if (row > 0) reach(pixel - width_);
      if (row + 1 < height) reach(pixel + width_);
    }
    return inside;
  }

  std::size_t width_;
  std::vector<std::uint8_t> in_;
};

/// Start position of a robot, in metres from the lower left corner: in the largest connected free space, and
/// there in the largest part through which it can drive, the pixel with enough room that is nearest to the
/// centre of the walls, otherwise one with the most room.
std::optional<geom::Vec2> place_for_robot(const Plan& plan, const Extent& walls) {
  const Region space =
      Region(plan.free, [&](std::size_t i) { return plan.free.solid[i] != 0; }).largest_part(walls);
  const std::vector<int> room = room_of(plan.free);
  int most = 0;
  for (std::size_t i = 0; i < room.size(); ++i)
    if (space.has(i)) most = std::max(most, room[i]);
  if (most == 0) return std::nullopt;
  const int enough = std::min(most, static_cast<int>(kRobotSize / plan.resolution) + 2);
  const Region roomy =
      Region(plan.free, [&](std::size_t i) { return space.has(i) && room[i] >= enough; }).largest_part(walls);
  const double middle_x = 0.5 * (walls.x0 + walls.x1), middle_y = 0.5 * (walls.y0 + walls.y1);
  std::optional<geom::Vec2> best;
  double nearest = 0;
  for (int row = 0, i = 0; row < plan.free.height; ++row)
    for (int x = 0; x < plan.free.width; ++x, ++i) {
      if (!roomy.has(static_cast<std::size_t>(i))) continue;
      const geom::Vec2 p{x + 0.5, plan.free.height - row - 0.5};
      const double away = (p.x - middle_x) * (p.x - middle_x) + (p.y - middle_y) * (p.y - middle_y);
      if (best && away >= nearest) continue;
      best = p;
      nearest = away;
    }
  return plan.resolution * *best;
}

/// Rounded to micrometres.
double rounded(double value) {
  const double whole = std::round(value * 1e6) / 1e6;
  return whole == 0 ? 0 : whole;
}

/// False for NaN.
bool is_of_a_world_file(double value) {
  return std::abs(value) <= kLargestNumber;
}

bool can_be_quoted(const std::string& text) {
  return std::ranges::none_of(text, [](char c) { return c == '"' || c == '\n' || c == '\r' || c == '\0'; });
}

}  // namespace

Result<Plan> plan_of_image(std::string_view bytes, std::string name, double resolution) {
  Result<Bitmap> solid = decode_bitmap(bytes);
  if (!solid) return solid.error();
  Plan plan{std::move(name), std::move(*solid), {}, resolution, {}};
  plan.free = plan.solid;
  for (std::uint8_t& pixel : plan.free.solid) pixel = pixel == 0;
  plan.X_WI = {-0.5 * plan.solid.width * resolution, -0.5 * plan.solid.height * resolution, 0, 0};
  return plan;
}

Result<std::string> world_of_plan(const Plan& plan, const std::string& bitmap, double height) {
  const std::optional<Extent> walls = extent_of(plan.solid);
  if (!walls) return Error{"", "has no dark pixel, so it has no walls"};
  if (plan.resolution < kLeastResolution) return Error{"", "has pixels of less than 0.01 mm"};
  if (!can_be_quoted(plan.name) || !can_be_quoted(bitmap))
    return Error{"", "has a name that a world file cannot hold: " + in_quotes(bitmap)};
  // Dark pixels of a bitmap fill the model's size; their margin is cropped.
  const geom::Vec2 size{(walls->x1 - walls->x0) * plan.resolution, (walls->y1 - walls->y0) * plan.resolution};
  const geom::Vec2 middle = geom::transform(plan.X_WI, {0.5 * (walls->x0 + walls->x1) * plan.resolution,
                                                        0.5 * (walls->y0 + walls->y1) * plan.resolution});
  const std::optional<geom::Vec2> place = place_for_robot(plan, *walls);
  const geom::Vec2 p = geom::transform(plan.X_WI, place.value_or(geom::Vec2{}));
  if (!std::ranges::all_of(std::array{size.x, size.y, height, middle.x, middle.y, p.x, p.y},
                           is_of_a_world_file))
    return Error{"", "has a place or a size beyond 1e9 m, the largest number of a world file"};
  const double turn = rounded(geom::degrees(plan.X_WI.a));
  std::string text = fmt::format(
      "# The floor plan {}, at {} m a pixel.\n\nname \"{}\"\nwindow( center [{} {}] scale {} show_data 1 "
      ")\n\n"
      "model( name \"walls\" bitmap \"{}\" size [{} {} {}] pose [{} {} 0 {}] color \"gray30\" gui_move 0 )\n",
      bitmap, plan.resolution, plan.name, rounded(middle.x), rounded(middle.y),
      rounded(700 / std::max(size.x, size.y)), bitmap, rounded(size.x), rounded(size.y), height,
      rounded(middle.x), rounded(middle.y), turn);
  if (place) {
    text += fmt::format(
        "\nposition( name \"guest\" pose [{} {} 0 {}] size [{} {} 0.3] color \"DodgerBlue\" localization "
        "\"gps\"\n"
        "  ranger( size [0.1 0.1 0.1] sensor( range [0 8] fov 180 samples 181 ) ) )\n",
        rounded(p.x), rounded(p.y), turn, kRobotSize, kRobotSize);
  }
  return text;
}

std::string pgm_of(const Bitmap& solid) {
  std::string image = fmt::format("P5\n{} {}\n255\n", solid.width, solid.height);
  for (const std::uint8_t pixel : solid.solid) image += pixel != 0 ? '\0' : '\xff';
  return image;
}

}  // namespace playhouse::scene
