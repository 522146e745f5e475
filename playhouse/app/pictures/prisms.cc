#include "playhouse/app/pictures/prisms.h"

#include <algorithm>

namespace playhouse::app {
namespace {

using geom::Vec2;

double doubled_area(const std::vector<Vec2>& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) sum += geom::cross(loop[i], loop[(i + 1) % loop.size()]);
  return sum;
}

std::vector<Vec2> in_model(const scene::ModelDesc& desc, const std::vector<Vec2>& loop_B) {
  const geom::Rotation turn = geom::Rotation::of(desc.X_MB.a);
  std::vector<Vec2> loop;
  for (const Vec2 p : loop_B) loop.push_back(desc.X_MB.xy() + turn * p);
  return loop;
}

}  // namespace

std::vector<Extrusion> prisms_of(const scene::ModelDesc& desc) {
  std::vector<Extrusion> prisms;
  for (const scene::Block& block : desc.blocks) {
    if (block.points.size() < 3) continue;
    prisms.push_back({{in_model(desc, block.points)}, block.z_min + desc.X_MB.z, block.z_max + desc.X_MB.z});
    std::vector<Vec2>& loop = prisms.back().loops.front();
    if (doubled_area(loop) < 0) std::ranges::reverse(loop);
  }
  for (const scene::Contours& bitmap : desc.bitmaps) {
    prisms.push_back({{}, bitmap.z_min + desc.X_MB.z, bitmap.z_max + desc.X_MB.z});
    for (const std::vector<Vec2>& loop : bitmap.loops)
      if (loop.size() >= 3) prisms.back().loops.push_back(in_model(desc, loop));
  }
  return prisms;
}

std::vector<geom::Trapezoid> top_of(const Extrusion& prism) {
  const std::vector<geom::Outline> outlines(prism.loops.begin(), prism.loops.end());
  return geom::trapezoids(outlines);
}

}  // namespace playhouse::app
