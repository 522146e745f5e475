#include "playhouse/stage/walls_between.h"

#include <algorithm>
#include <cmath>

#include "playhouse/stage/ray_edge.h"

namespace playhouse::stage {

int walls_between(const Space& space, const Pose& from_W, const Pose& to_W, Observers by,
                  std::vector<std::uint32_t>& crossed) {
  const Vec2 p = from_W.xy(), way = to_W.xy() - p;
  const double distance = std::sqrt(geom::dot(way, way));
  if (distance == 0) return 0;
  const Vec2 d = (1.0 / distance) * way;
  crossed.clear();
  space.walls.along(p, d, &distance, [&](const Walls::Edge& edge) {
    if ((space.solids.seen_by[edge.solid] & by) == 0 || !at_height(space.solids, edge.solid, from_W.z))
      return;
    const Vec2 w0 = edge.a - p, w1 = edge.b - p;
    const Crossing<double> ends({d.x, d.y, w0.x, w0.y}, {d.x, d.y, w1.x, w1.y});
    if (ends.enters && edge_hit(w0, w1, d) < distance) crossed.push_back(edge.number);
  });
  std::ranges::sort(crossed);  // removes duplicates: an edge is listed in each of its cells
  return static_cast<int>(std::unique(crossed.begin(), crossed.end()) - crossed.begin());
}

}  // namespace playhouse::stage
