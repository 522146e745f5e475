#include "playhouse/world/drawing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/scene/forms/colors.h"

namespace playhouse::world {
namespace {

bool is_finite(const DrawnCorner& corner) {
  return std::isfinite(corner.x) && std::isfinite(corner.y) && std::isfinite(corner.z);
}

bool belong_together(const DrawnCorner& a, const DrawnCorner& b) {
  return a.color == b.color && a.corners == b.corners && a.layer == b.layer;
}

bool is_shape(std::span<const DrawnCorner> shape) {
  return shape.front().layer < kLayers && std::ranges::all_of(shape, [&](const DrawnCorner& corner) {
           return is_finite(corner) && belong_together(corner, shape.front());
         });
}

bool fits(std::span<const DrawnCorner> drawing, const DrawnShapes& shapes) {
  return shapes.layer < kLayers && shapes.corners >= 1 && shapes.corners <= 3 && !shapes.points.empty() &&
         shapes.points.size() % shapes.corners == 0 && shapes.points.size() <= limits::kDrawnCorners &&
         corners_in(drawing, shapes.layer) + shapes.points.size() <= limits::kDrawnCorners;
}

}  // namespace

std::size_t corners_in(std::span<const DrawnCorner> drawing, std::uint32_t layer) {
  return static_cast<std::size_t>(std::ranges::count(drawing, layer, &DrawnCorner::layer));
}

bool is_drawing(std::span<const DrawnCorner> drawing) {
  for (std::uint32_t layer = 0; layer < kLayers; ++layer)
    if (corners_in(drawing, layer) > limits::kDrawnCorners) return false;
  while (!drawing.empty()) {
    const std::size_t corners = drawing.front().corners;
    if (corners < 1 || corners > 3 || corners > drawing.size()) return false;
    if (!is_shape(drawing.first(corners))) return false;
    drawing = drawing.subspan(corners);
  }
  return true;
}

bool draw(World& world, ModelRow model, const DrawnShapes& shapes) {
  const scene::Color& c = shapes.color;
  if (!fits(world.models.drawing[model], shapes) || !std::isfinite(c.r + c.g + c.b + c.a)) return false;
  std::vector<DrawnCorner> added;
  added.reserve(shapes.points.size());
  for (const geom::Vec3& p : shapes.points) {
    added.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z),
                     scene::rgba8(c), static_cast<std::uint8_t>(shapes.corners),
                     static_cast<std::uint8_t>(shapes.layer)});
    if (!is_finite(added.back())) return false;
  }
  std::vector<DrawnCorner>& drawing = world.models.drawing.own(model);
  drawing.insert(drawing.end(), added.begin(), added.end());
  ++world.drawn_;
  return true;
}

void clear_drawing(World& world, ModelRow model, std::uint32_t layer) {
  if (corners_in(world.models.drawing[model], layer) == 0) return;
  std::vector<DrawnCorner>& drawing = world.models.drawing.own(model);
  std::erase_if(drawing, [=](const DrawnCorner& corner) { return corner.layer == layer; });
  ++world.drawn_;
}

}  // namespace playhouse::world
