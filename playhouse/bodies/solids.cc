#include "playhouse/bodies/solids.h"

namespace playhouse::bodies {

std::vector<geom::Vec2> moved(const geom::Pose& X_WB, std::span<const geom::Vec2> points) {
  std::vector<geom::Vec2> result;
  result.reserve(points.size());
  for (const geom::Vec2 p : points) result.push_back(geom::transform(X_WB, p));
  return result;
}

void add_blocks(const scene::ModelDesc& desc, const geom::Pose& X_WM, std::vector<Solid>& solids) {
  if (!desc.obstacle_return) return;
  const geom::Pose X_WB = geom::compose(X_WM, desc.X_MB);
  for (const scene::Block& block : desc.blocks)
    solids.push_back({moved(X_WB, block.points), X_WB.z + block.z_min, X_WB.z + block.z_max});
}

Polygon outline_of(const Solid& solid) {
  geom::Vec2 sum{};
  for (const geom::Vec2 p : solid.p) sum = sum + p;
  return {solid.p, (1.0 / static_cast<double>(solid.p.size())) * sum, is_convex(solid.p)};
}

bool share_heights(const Solid& solid, double bottom, double top) {
  return solid.bottom < top && bottom < solid.top;
}

}  // namespace playhouse::bodies
