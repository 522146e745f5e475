#include "playhouse/arena/triangles.h"

namespace playhouse::arena {
namespace {

using geom::Vec3;

void add_quad(Triangles& triangles, const std::array<Vec3, 4>& corners) {
  const auto first = static_cast<std::uint32_t>(triangles.p.size());
  triangles.p.insert(triangles.p.end(), corners.begin(), corners.end());
  triangles.corner.push_back({first, first + 1, first + 2});
  triangles.corner.push_back({first, first + 2, first + 3});
}

}  // namespace

void add_extrusion(Triangles& triangles, std::span<const geom::Outline> outlines, double z_low,
                   double z_high) {
  for (const geom::Outline& outline : outlines)
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const geom::Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
      add_quad(triangles, {{{a.x, a.y, z_low}, {b.x, b.y, z_low}, {b.x, b.y, z_high}, {a.x, a.y, z_high}}});
    }
  for (const geom::Trapezoid& t : geom::trapezoids(outlines)) {
    add_quad(triangles, {{{t.left_low, t.y_low, z_high},
                          {t.right_low, t.y_low, z_high},
                          {t.right_high, t.y_high, z_high},
                          {t.left_high, t.y_high, z_high}}});
    add_quad(triangles, {{{t.left_low, t.y_low, z_low},
                          {t.left_high, t.y_high, z_low},
                          {t.right_high, t.y_high, z_low},
                          {t.right_low, t.y_low, z_low}}});
  }
}

}  // namespace playhouse::arena
