#include "playhouse/scene/forms/body.h"

#include <algorithm>
#include <cmath>

#include "playhouse/base/in_quotes.h"
#include "playhouse/scene/text/read_word.h"

namespace playhouse::scene {
namespace {

constexpr double kWall = 0.01;  // m

double signed_area(const std::vector<geom::Vec2>& points) {
  double twice = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    twice += geom::cross(points[i], points[(i + 1) % points.size()]);
  return twice / 2;
}

/// A thin rectangle around collinear `points`, counter-clockwise; empty if they coincide.
std::vector<geom::Vec2> thin_wall(const std::vector<geom::Vec2>& points) {
  const auto [first, last] =
      std::minmax_element(points.begin(), points.end(),
                          [](geom::Vec2 a, geom::Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  const geom::Vec2 p = *first, q = *last;
  const double dx = q.x - p.x, dy = q.y - p.y, length = std::sqrt(dx * dx + dy * dy);
  if (!(length > 0)) return {};
  const double x = -dy / length * kWall / 2, y = dx / length * kWall / 2;  // to the left of the line
  return {{p.x - x, p.y - y}, {q.x - x, q.y - y}, {q.x + x, q.y + y}, {p.x + x, p.y + y}};
}

/// Maps the joint bounding box of a shape onto a size.
struct Stretch {
  geom::Box box;
  Interval z{0, 0};  // including the floor
  geom::Size size;

  /// True if all points are on a line parallel to an axis.
  bool flat() const { return !(box.x_max > box.x_min) || !(box.y_max > box.y_min); }
  geom::Vec2 operator()(geom::Vec2 p) const {
    const auto onto = [](double v, double min, double max, double width) {
      return max > min ? ((v - min) / (max - min) - 0.5) * width : -0.5 * width;
    };
    return {onto(p.x, box.x_min, box.x_max, size.x), onto(p.y, box.y_min, box.y_max, size.y)};
  }
  Interval operator()(const std::optional<Interval>& b) const {
    if (!b) return {0, size.z};
    return {b->min / (z.max - z.min) * size.z, b->max / (z.max - z.min) * size.z};
  }
  std::vector<geom::Vec2> operator()(const std::vector<geom::Vec2>& points) const {
    std::vector<geom::Vec2> mapped;
    mapped.reserve(points.size());
    for (const geom::Vec2 p : points) mapped.push_back((*this)(p));
    return mapped;
  }
};

Stretch stretch_of(const UnscaledBody& shape, const geom::Size& size) {
  Stretch stretch{{}, {}, size};
  const auto widen = [&stretch](Interval z) {
    stretch.z = {std::min(stretch.z.min, z.min), std::max(stretch.z.max, z.max)};
  };
  for (const Prism& prism : shape.prisms) {
    for (const geom::Vec2 p : prism.points) stretch.box.add(p);
    if (prism.z) widen(*prism.z);
  }
  for (const auto& loop : shape.contours) {
    for (const geom::Vec2 p : loop) stretch.box.add(p);
  }
  if (!shape.contours.empty()) widen({0, 1});
  return stretch;
}

}  // namespace

Prism read_block(const Properties& properties) {
  LoadState& state = properties.state();
  Prism prism{{}, {}, properties.where("points")};
  const int count = properties.integer("points", 0);
  if (count < 2) state.fail(prism.where, "a block needs \"points\" of at least 2");
  std::string first_missing;
  for (int i = 0; i < count && !state.error; ++i) {
    const std::string key = "point[" + std::to_string(i) + "]";
    double v[2] = {};
    if (!properties.tuple(key, "LL", v, "[x y]") && first_missing.empty()) first_missing = key;
    prism.points.push_back({v[0], v[1]});
  }
  if (!first_missing.empty()) {
    state.warnings.add(config::Warning::kShape, prism.where,
                       "the block has " + std::to_string(count) + " points, but " + in_quotes(first_missing) +
                           " is missing; what is missing is [0 0]");
  }
  warn_of_uncounted(properties, "point", "points", static_cast<std::uint32_t>(std::max(0, count)));
  if (properties.has("point"))
    state.warnings.add(config::Warning::kNoEffect, properties.where("point"),
                       "\"point\" has no effect without a number: point[0], point[1] ...");
  double z[2] = {};
  properties.tuple("z", "LL", z, "[min max]");
  if (z[1] < z[0]) state.fail(properties.where("z"), "the block ends below its start: z [min max]");
  if (z[1] > z[0]) {
    prism.z = Interval{z[0], z[1]};
  } else if (!state.error) {
    state.warnings.add(
        config::Warning::kShape, prism.where,
        std::string(properties.has("z") ? "the block has no height" : "the block has no \"z\"") +
            "; it is as high as the model");
  }
  return prism;
}

void fit_shape(const UnscaledBody& shape, const geom::Size& size, LoadState& state, ModelDesc& model) {
  const Stretch stretch = stretch_of(shape, size);
  if (stretch.box.empty()) return;
  for (const Prism& prism : shape.prisms) {
    const Interval z = stretch(prism.z);
    Block block{stretch(prism.points), z.min, z.max};
    if (stretch.flat() || block.points.size() == 2) {
      block.points = thin_wall(block.points);
      state.warnings.add(config::Warning::kShape, prism.where,
                         block.points.empty() ? "all points of the block are one point, so it has no body"
                                              : "the block is a line; it is a wall 0.01 m thick");
      if (block.points.empty()) continue;
    }
    if (signed_area(block.points) < 0) std::reverse(block.points.begin(), block.points.end());
    model.blocks.push_back(std::move(block));
  }
  if (shape.contours.empty()) return;
  const Interval z = stretch(Interval{0, 1});
  Contours contours{{}, z.min, z.max};
  for (const auto& loop : shape.contours) contours.loops.push_back(stretch(loop));
  model.bitmaps.push_back(std::move(contours));
}

std::optional<geom::Size> body_size(const geom::Size& size) {
  if (size.x == 0 && size.y == 0) return std::nullopt;
  return geom::Size{size.x > 0 ? size.x : kWall, size.y > 0 ? size.y : kWall, size.z};
}

void check_body_size(const geom::Size& size, const Properties& properties) {
  const auto warn = [&](std::string_view what) {
    properties.state().warnings.add(config::Warning::kShape, properties.where("size"),
                                    "\"size\" has no extent in " + std::string(what));
  };
  if (size.x == 0 && size.y == 0) return warn("x and y, so the model has no body");
  if (size.x == 0) warn("x; the body is 0.01 m thick there");
  if (size.y == 0) warn("y; the body is 0.01 m thick there");
  if (size.z == 0) warn("z, so the body collides with nothing");
}

Block rectangle(double x_min, double y_min, double x_max, double y_max, Interval z) {
  return {{{x_min, y_min}, {x_max, y_min}, {x_max, y_max}, {x_min, y_max}}, z.min, z.max};
}

Block box_block(const geom::Size& size) {
  return rectangle(-size.x / 2, -size.y / 2, size.x / 2, size.y / 2, {0, size.z});
}

std::vector<Block> boundary_walls(const geom::Size& size) {
  const double x = size.x / 2, y = size.y / 2;
  const double tx = std::min(kWall, x), ty = std::min(kWall, y);
  const Interval z{0, size.z};
  return {rectangle(-x, -y, -x + tx, y, z), rectangle(x - tx, -y, x, y, z), rectangle(-x, -y, x, -y + ty, z),
          rectangle(-x, y - ty, x, y, z)};
}

}  // namespace playhouse::scene
