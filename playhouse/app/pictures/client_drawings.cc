#include "playhouse/app/pictures/client_drawings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "playhouse/geom/orientation.h"
#include "playhouse/world/drawing.h"

namespace playhouse::app {
namespace {

using geom::Vec2;
using geom::Vec3;

constexpr double kPointWidths = 3;  // side of a point, in widths of a line

scene::Color color_of_drawing(std::uint32_t rgba) {
  const auto share = [rgba](unsigned shift) { return static_cast<float>(rgba >> shift & 0xff) / 255; };
  return {share(24), share(16), share(8), share(0)};
}

std::vector<Vec2> outline_of(std::span<const Vec3> shape, double line_width) {
  const auto xy = [&](std::size_t k) { return Vec2{shape[k].x, shape[k].y}; };
  if (shape.size() == 1) {
    const double half = 0.5 * kPointWidths * line_width;
    const Vec2 p = xy(0);
    return {{p.x - half, p.y - half},
            {p.x + half, p.y - half},
            {p.x + half, p.y + half},
            {p.x - half, p.y + half}};
  }
  if (shape.size() == 3) return {xy(0), xy(1), xy(2)};
  const Vec2 from = xy(0), to = xy(1), way = to - from;
  const double length = std::sqrt(geom::dot(way, way));
  if (length == 0) return {};  // upright, or a point
  const Vec2 aside = (0.5 * line_width / length) * Vec2{-way.y, way.x};
  return {from - aside, to - aside, to + aside, from + aside};
}

/// Triangles of one color and height become one shape.
class DrawingShapes {
 public:
  DrawingShapes(std::vector<FilledShape>& shapes, double line_width)
      : shapes_(shapes), line_width_(line_width) {}

  /// On the floor triangles, then lines, then points, which later ones of one height cover.
  void add(const geom::SpatialPose& X_WM, std::span<const world::DrawnCorner> drawing) {
    for (const unsigned corners : {3u, 2u, 1u})
      add_those(X_WM, drawing, [=](const world::DrawnCorner& c) {
        return c.layer == world::kLayer2d && c.corners == corners;
      });
    add_those(X_WM, drawing, [](const world::DrawnCorner& c) { return c.layer != world::kLayer2d; });
  }

 private:
  template <typename Choose>
  void add_those(const geom::SpatialPose& X_WM, std::span<const world::DrawnCorner> drawing,
                 const Choose& choose) {
    const geom::Quaternion q_WM = geom::orientation(X_WM.X.a, X_WM.tilt);
    const Vec3 p_WM{X_WM.X.x, X_WM.X.y, X_WM.X.z};
    triangles_ = nullptr;
    std::vector<Vec3> shape;
    for (std::size_t count = 0; !drawing.empty(); drawing = drawing.subspan(count)) {
      count = drawing[0].corners;
      if (!choose(drawing[0])) continue;
      shape.clear();
      for (const world::DrawnCorner& c : drawing.first(count))
        shape.push_back(
            p_WM + q_WM * Vec3{static_cast<double>(c.x), static_cast<double>(c.y), static_cast<double>(c.z)});
      add(shape, drawing[0].color);
    }
  }

  void add(std::span<const Vec3> shape, std::uint32_t rgba) {
    std::vector<Vec2> outline = outline_of(shape, line_width_);
    if (outline.empty()) return;
    const double top = std::ranges::max(shape, {}, &Vec3::z).z;
    const bool goes_on = shape.size() == 3 && triangles_ && rgba == rgba_ && triangles_->z_max == top;
    if (goes_on) return triangles_->loops.push_back(std::move(outline));
    shapes_.push_back({{std::move(outline)}, top, color_of_drawing(rgba), true});
    triangles_ = shape.size() == 3 ? &shapes_.back() : nullptr;
    rgba_ = rgba;
  }

  std::vector<FilledShape>& shapes_;
  const double line_width_;
  FilledShape* triangles_ = nullptr;  // the last shape, if it is of triangles
  std::uint32_t rgba_ = 0;            // its color
};

}  // namespace

void add_client_drawings(std::vector<FilledShape>& shapes, const world::World& world, double line_width) {
  if (world.drawn() == 0) return;
  DrawingShapes drawings(shapes, line_width);
  for (const world::ModelRow row : world.models.rows())
    if (!world.models.drawing[row].empty())
      drawings.add(world::pose_in_world(world.models, row), world.models.drawing[row]);
}

}  // namespace playhouse::app
