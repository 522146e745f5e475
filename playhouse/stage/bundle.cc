/// Bundles: the single rays of a ranger, traced together. Bodies come first: their table lookup is cheap
/// and shortens the rays for the more expensive wall traversal, which is batched with other rangers' rays.

#include <algorithm>
#include <bit>
#include <cmath>

#include "playhouse/stage/bundle.h"
#include "playhouse/stage/march.h"
#include "playhouse/stage/polygon_hit.h"
#include "playhouse/stage/sense_ranger.h"
#include "playhouse/stage/vectors.h"

namespace playhouse::stage {
namespace {

/// Appends the rays of a bundle in W, as this part.
PLAYHOUSE_INLINE void put_rays(const Bundle& bundle, const Pose& X_WM, Rotation r, std::size_t first_beam,
                               const Rays::Part& part, Rays& rays) {
  const std::size_t count = bundle.rays(), first = part.begin;
  const double *px = bundle.p.x.data(), *py = bundle.p.y.data(), *dx = bundle.d.x.data(),
               *dy = bundle.d.y.data();
  for (std::size_t k = 0; k < count; ++k) {
    rays.px[first + k] = X_WM.x + (r.c * px[k] - r.s * py[k]);
    rays.py[first + k] = X_WM.y + (r.s * px[k] + r.c * py[k]);
    rays.dx[first + k] = r.c * dx[k] - r.s * dy[k];
    rays.dy[first + k] = r.s * dx[k] + r.c * dy[k];
    rays.ahead_x[first + k] = static_cast<float>(rays.dx[first + k]);
    rays.ahead_y[first + k] = static_cast<float>(rays.dy[first + k]);
    rays.z[first + k] = X_WM.z + bundle.z[k];
    rays.range[first + k] = bundle.range_max[k];
    rays.solid[first + k] = kNoSolid;
    rays.beam[first + k] = first_beam + bundle.beam[k];
  }
  rays.count = part.end;
  rays.parts[rays.part_count++] = part;
}

/// find_bodies() for rays beyond the exact range of DiscIndex units: takes all bodies visible to rangers.
std::size_t take_all(const Bundle& bundle, const DiscIndex& index, std::span<const DiscIndex::Run> runs,
                     std::uint32_t own_root, const NearBodies& out) {
  std::size_t count = 0;
  for (const DiscIndex::Run& run : runs) {
    for (std::uint32_t place = run.begin; place < run.end; ++place) {
      const DiscIndex::Disc& disc = index.discs()[place];
      if ((disc.seen_by & bit(Observer::kRanger)) == 0 || disc.root == own_root) continue;
      out.place[count] = place;
      out.rays[count++] = static_cast<std::uint16_t>((1u << bundle.rays()) - 1);
    }
  }
  return count;
}

/// Shortens the rays of a part by their hits with an edge.
PLAYHOUSE_INLINE void meet_edge(Vec2 a, Vec2 b, double row, const Rays::Part& part, Rays& rays) {
  FourTruths edge_on = {};
  std::size_t k = part.begin;
  for (; k + kFour <= part.end; k += kFour) {
    Four px, py, dx, dy, range, solid;
    load(px, rays.px + k);
    load(py, rays.py + k);
    load(dx, rays.dx + k);
    load(dy, rays.dy + k);
    load(range, rays.range + k);
    load(solid, rays.solid + k);
    const Distance<Four, Four> met(dx, dy, a.x - px, a.y - py, b.x - px, b.y - py);
    edge_on |= met.edge_on;
    keep_first(met.t, Four{row, row, row, row}, range, solid);
    store(rays.range + k, range);
    store(rays.solid + k, solid);
  }
  for (k = any(edge_on) ? part.begin : k; k < part.end; ++k)
    keep_first(edge_hit(a - rays.p(k), b - rays.p(k), rays.d(k)), row, rays.range[k], rays.solid[k]);
}

}  // namespace

/// Traces the rays of a part one by one, if they cannot march.
void RangerSense::meet_walls_alone(const Space& space, const Rays::Part& part, Rays& rays) {
  for (std::size_t k = part.begin; k < part.end; ++k) {
    const Vec2 p = rays.p(k), d = rays.d(k);
    space.walls.along(p, d, &rays.range[k], [&](const Walls::Edge& edge) {
      if (!View::sees(space.solids, edge.solid, part.root, rays.z[k])) return;
      const double t = edge_hit(edge.a - p, edge.b - p, d);
      keep_first(t, number_of(edge.solid), rays.range[k], rays.solid[k]);
    });
  }
}

void RangerSense::meet_few_walls(const Space& space, const Rays::Part& part, Rays& rays) {
  const geom::Box box = box_about(part.about, part.reach);
  for (const Walls::Edge& edge : space.walls.few())
    if (edge.reaches(box) && View::sees(space.solids, edge.solid, part.root, rays.z[part.begin]))
      in_vectors<meet_edge>(edge.a, edge.b, number_of(edge.solid), part, rays);
}

void RangerSense::run_bundle(const Space& space, const View& view, const Bundle& bundle, Scratch& scratch) {
  if (scratch.rays.count + bundle.rays() > Rays::kMost) finish_rays(space, scratch);
  Rays& rays = scratch.rays;
  const Rays::Part part{view.X_WM.xy(), rays.count,   rays.count + bundle.rays(),  bundle.reach,
                        view.root,      view.is_wall, bundle.z_min == bundle.z_max};
  in_vectors<put_rays>(bundle, view.X_WM, view.rotation, scratch.first_beam, part, rays);
  const double z_low = view.X_WM.z + bundle.z_min, z_high = view.X_WM.z + bundle.z_max;
  const Heights heights{z_low, z_high, space.index.is_all_seen(z_low, z_high)};
  const NearBodies near{scratch.place.data(), scratch.cell.data(), scratch.met_by.data()};
  for (std::size_t size = 0; size < space.index.radii().size(); ++size) {
    const std::span<const DiscIndex::Run> runs =
        space.index.find_runs(size, view.X_WM.xy(), bundle.reach, z_low, z_high, scratch.runs);
    if (runs.empty()) continue;
    const Bundle::Table& table = bundle.tables[size];
    const std::size_t count = table.half < DiscIndex::kFarthest
                                  ? find_bodies(table, space.index.places(), runs, view.X_WM.xy(),
                                                view.rotation, view.root, heights, near)
                                  : take_all(bundle, space.index, runs, view.root, near);
    add_pairs(space, near, count, part.begin, heights, rays, scratch.pairs);
  }
}

bool RangerSense::can_march(const Walls& walls, const Rays::Part& part) {
  return !part.is_wall && part.reach < kFarthestMarch * walls.torus().cell();
}

/// Resolves the rays of all bundles that wait: bodies come first, which shortens the rays for the walls.
void RangerSense::finish_rays(const Space& space, Scratch& scratch) {
  Rays& rays = scratch.rays;
  if (rays.count == 0) return;
  resolve_pairs(space, rays, scratch.pairs);
  std::size_t marching = 0;
  for (std::size_t i = 0; i < rays.part_count; ++i) {
    const Rays::Part part = rays.parts[i];
    if (space.walls.clear_about(part.about) > part.reach) continue;
    if (!space.walls.few().empty() && part.is_level)
      meet_few_walls(space, part, rays);
    else if (can_march(space.walls, part))
      rays.parts[marching++] = part;
    else
      meet_walls_alone(space, part, rays);
  }
  rays.part_count = marching;
  if (marching > 0) march(space.walls, View::kBy, rays);
  for (std::size_t k = 0; k < rays.count; ++k) {
    scratch.range[rays.beam[k]] = rays.range[k];
    scratch.solid[rays.beam[k]] = rays.solid[k];
  }
  rays.count = rays.part_count = 0;
}

}  // namespace playhouse::stage
