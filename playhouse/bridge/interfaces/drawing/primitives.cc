#include "playhouse/bridge/interfaces/drawing/primitives.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "playhouse/geom/trapezoids.h"
#include "playhouse/wire/generated/graphics3d.h"

namespace playhouse::drivers {
namespace {

using Points = std::span<const geom::Vec3>;

bool is_within_reach(const geom::Vec3& p) {
  return std::fabs(p.x) <= kFarthest && std::fabs(p.y) <= kFarthest && std::fabs(p.z) <= kFarthest;
}

class ShapeMaker {
 public:
  explicit ShapeMaker(std::size_t corners) { made_.corners = corners; }

  void add(std::initializer_list<geom::Vec3> shape) {
    if (std::ranges::all_of(shape, is_within_reach))
      made_.points.insert(made_.points.end(), shape.begin(), shape.end());
  }
  Primitives take() { return std::move(made_); }

 private:
  Primitives made_;
};

Primitives separate_points(Points p) {
  ShapeMaker maker(1);
  for (const geom::Vec3& each : p) maker.add({each});
  return maker.take();
}

Primitives separate_lines(Points p) {
  ShapeMaker maker(2);
  for (std::size_t i = 0; i + 1 < p.size(); i += 2) maker.add({p[i], p[i + 1]});
  return maker.take();
}

Primitives line_strip(Points p, bool is_closed) {
  ShapeMaker maker(2);
  for (std::size_t i = 0; i + 1 < p.size(); ++i) maker.add({p[i], p[i + 1]});
  if (is_closed && p.size() > 2) maker.add({p.back(), p.front()});
  return maker.take();
}

Primitives separate_triangles(Points p) {
  ShapeMaker maker(3);
  for (std::size_t i = 0; i + 2 < p.size(); i += 3) maker.add({p[i], p[i + 1], p[i + 2]});
  return maker.take();
}

Primitives triangle_strip(Points p) {
  ShapeMaker maker(3);
  for (std::size_t i = 0; i + 2 < p.size(); ++i) maker.add({p[i], p[i + 1], p[i + 2]});
  return maker.take();
}

Primitives triangle_fan(Points p) {
  ShapeMaker maker(3);
  for (std::size_t i = 1; i + 1 < p.size(); ++i) maker.add({p[0], p[i], p[i + 1]});
  return maker.take();
}

Primitives separate_quads(Points p) {
  ShapeMaker maker(3);
  for (std::size_t i = 0; i + 3 < p.size(); i += 4) {
    maker.add({p[i], p[i + 1], p[i + 2]});
    maker.add({p[i], p[i + 2], p[i + 3]});
  }
  return maker.take();
}

/// Each further pair of corners continues the strip, so they are those of a strip of triangles.
Primitives quad_strip(Points p) {
  return triangle_strip(p.first(p.size() / 2 * 2));
}

std::vector<geom::Vec3> at_height(std::span<const geom::Vec2> outline, double height) {
  std::vector<geom::Vec3> points;
  for (const geom::Vec2& p : outline) points.push_back({p.x, p.y, height});
  return points;
}

}  // namespace

std::optional<Primitives> primitives_of(std::uint32_t mode, Points points) {
  namespace g3d = wire::graphics3d;
  switch (mode) {
    case g3d::kDrawPoints:
      return separate_points(points);
    case g3d::kDrawLines:
      return separate_lines(points);
    case g3d::kDrawLineStrip:
      return line_strip(points, false);
    case g3d::kDrawLineLoop:
      return line_strip(points, true);
    case g3d::kDrawTriangles:
      return separate_triangles(points);
    case g3d::kDrawTriangleStrip:
      return triangle_strip(points);
    case g3d::kDrawTriangleFan:
    case g3d::kDrawPolygon:
      return triangle_fan(points);
    case g3d::kDrawQuads:
      return separate_quads(points);
    case g3d::kDrawQuadStrip:
      return quad_strip(points);
    default:
      return std::nullopt;
  }
}

Primitives filled(std::span<const geom::Vec2> outline, double height) {
  std::vector<geom::Vec2> corners;
  for (const geom::Vec2& p : outline)
    if (is_within_reach({p.x, p.y, height})) corners.push_back(p);
  if (corners.size() > kFilledExactly) return triangle_fan(at_height(corners, height));
  ShapeMaker maker(3);
  const geom::Outline only(corners);
  for (const geom::Trapezoid& t : geom::trapezoids({&only, 1})) {
    const geom::Vec3 low_left{t.left_low, t.y_low, height}, low_right{t.right_low, t.y_low, height},
        high_left{t.left_high, t.y_high, height}, high_right{t.right_high, t.y_high, height};
    if (t.left_low < t.right_low) maker.add({low_left, low_right, high_right});
    if (t.left_high < t.right_high) maker.add({low_left, high_right, high_left});
  }
  return maker.take();
}

}  // namespace playhouse::drivers
