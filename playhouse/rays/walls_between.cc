#include "playhouse/rays/walls_between.h"

#include <algorithm>
#include <cmath>

#include "playhouse/bodies/ray_edge.h"

namespace playhouse::rays {

int walls_between(const bodies::Space& space, const geom::Pose& from_W, const geom::Pose& to_W,
                  bodies::SeenByBits by, std::vector<bodies::EdgeRow>& crossed, world::ModelRow own,
                  world::ModelRow target) {
  const geom::Vec2 p = from_W.xy(), way = to_W.xy() - p;
  const double distance = std::sqrt(geom::dot(way, way));
  if (distance == 0) return 0;
  const geom::Vec2 d = (1.0 / distance) * way;
  crossed.clear();
  space.walls.along(p, d, &distance, [&](const bodies::Walls::Edge& edge) {
    if ((space.solids.seen_by[edge.solid] & by) == 0 || !at_height(space.solids, edge.solid, from_W.z))
      return;
    const world::ModelRow root = space.solids.root[edge.solid];
    if (root == own || root == target) return;
    const geom::Vec2 w0 = edge.a - p, w1 = edge.b - p;
    const bodies::Crossing<double> ends({d.x, d.y, w0.x, w0.y}, {d.x, d.y, w1.x, w1.y});
    if (ends.enters && bodies::edge_hit(w0, w1, d) < distance) crossed.push_back(edge.row);
  });
  std::ranges::sort(crossed);  // removes duplicates: an edge is listed in each of its cells
  return static_cast<int>(std::unique(crossed.begin(), crossed.end()) - crossed.begin());
}

}  // namespace playhouse::rays
