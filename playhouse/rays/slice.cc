#include "playhouse/rays/slice.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "playhouse/bodies/ray_edge.h"

namespace playhouse::rays {
namespace {

constexpr double kEndless = 1e300;  // m

}  // namespace

bool Slicer::shows(const bodies::Solids& solids, bodies::SolidRow solid) const {
  return (solids.seen_by[solid] & by_) != 0 && solids.root[solid] != root_;
}

void Slicer::stand(const bodies::Space& space, geom::Vec2 p, double z, double reach, bodies::SeenByBits by,
                   world::ModelRow root) {
  p_ = p;
  z_ = z;
  by_ = by;
  root_ = root;
  near_.clear();
  space.index.near(p, reach, -kEndless, kEndless, [&](const bodies::DiscIndex::Disc& disc) {
    const geom::Vec2 w = disc.center - p;
    const double least = disc.radius + reach;
    if (geom::dot(w, w) <= least * least && shows(space.solids, disc.solid())) near_.push_back(disc.solid());
  });
  // Bodies that contain p: those that a line to the edge of the world leaves before it enters.
  beneath_.clear();
  crossings_.clear();
  cross_walls(space, {1, 0}, kEndless);
  pair_crossings(space.solids);
  for (const Stretch& stretch : stretches_)
    if (stretch.from == 0) beneath_.push_back(space.solids.body[stretch.solid]);
  std::ranges::sort(beneath_);
  beneath_.erase(std::unique(beneath_.begin(), beneath_.end()), beneath_.end());
}

void Slicer::cross(bodies::SolidRow body, geom::Vec2 w0, geom::Vec2 w1, bool hole, double reach, geom::Vec2 d,
                   bodies::EdgeRow wall) {
  const bodies::Crossing<double> ends({d.x, d.y, w0.x, w0.y}, {d.x, d.y, w1.x, w1.y});
  if (!ends.crosses) return;
  const double t = bodies::edge_hit(w0, w1, d);
  if (t <= reach) crossings_.push_back({body, t, ends.enters != hole, wall});
}

void Slicer::cross_walls(const bodies::Space& space, geom::Vec2 d, double reach) {
  const bodies::Solids& solids = space.solids;
  const auto meet = [&](const bodies::Walls::Edge& edge) {
    if (shows(solids, edge.solid))
      cross(solids.body[edge.solid], edge.a - p_, edge.b - p_, solids.hole[edge.solid] != 0, reach, d,
            edge.row);
  };
  if (!space.walls.few().empty()) {
    for (const bodies::Walls::Edge& edge : space.walls.few()) meet(edge);
    return;
  }
  const std::size_t before = crossings_.size();
  space.walls.along(p_, d, &reach, meet);
  // Removes duplicates: an edge is listed in each of its cells.
  const auto begin = crossings_.begin() + static_cast<std::ptrdiff_t>(before);
  std::ranges::sort(begin, crossings_.end(), {}, &Passage::wall);
  const auto same = [](const Passage& a, const Passage& b) { return a.wall == b.wall; };
  crossings_.erase(std::unique(begin, crossings_.end(), same), crossings_.end());
}

void Slicer::cross_bodies(const bodies::Space& space, geom::Vec2 d, double reach) {
  const bodies::Solids& solids = space.solids;
  for (const bodies::SolidRow solid : near_) {
    const geom::Vec2 to = solids.center[solid] - p_;
    const double radius = solids.radius[solid] + bodies::kMargin;
    if (std::fabs(geom::cross(d, to)) > radius || geom::dot(d, to) < -radius) continue;
    const bodies::VertexRows vertices = solids.vertices_of(solid);
    for (std::uint32_t i = 0; i + 1 < vertices.size(); ++i)
      cross(solids.body[solid], solids.p[vertices[i]] - p_, solids.p[vertices[i + 1]] - p_,
            solids.hole[solid] != 0, reach, d, {});
  }
}

void Slicer::add(const bodies::Solids& solids, bodies::SolidRow body, double from, double to) {
  stretches_.push_back({from, to, solids.z_min[body] - z_, solids.z_max[body] - z_, body});
}

void Slicer::pair_crossings(const bodies::Solids& solids) {
  std::ranges::sort(crossings_, [](const Passage& a, const Passage& b) {
    return std::tuple(a.body, a.t, !a.enters) < std::tuple(b.body, b.t, !b.enters);
  });
  stretches_.clear();
  for (std::size_t i = 0; i < crossings_.size();) {
    const bodies::SolidRow body = crossings_[i].body;
    int depth = crossings_[i].enters ? 0 : 1;
    double from = 0;
    for (; i < crossings_.size() && crossings_[i].body == body; ++i) {
      const Passage& crossing = crossings_[i];
      if (crossing.enters && depth++ == 0) from = crossing.t;
      if (!crossing.enters && depth > 0 && --depth == 0) add(solids, body, from, crossing.t);
    }
    if (depth > 0) add(solids, body, from, kEndless);
  }
}

const std::vector<Stretch>& Slicer::along(const bodies::Space& space, geom::Vec2 d, double reach) {
  crossings_.clear();
  cross_walls(space, d, reach);
  cross_bodies(space, d, reach);
  pair_crossings(space.solids);
  for (const bodies::SolidRow body : beneath_)  // their exit is beyond the reach
    if (!std::ranges::binary_search(crossings_, body, {}, &Passage::body))
      add(space.solids, body, 0, kEndless);
  return stretches_;
}

}  // namespace playhouse::rays
