/// Bundles: the single rays of a ranger, traced together. Bodies come first: their table lookup is cheap
/// and shortens the rays for the more expensive wall traversal, which is batched with other rangers' rays.

#include <algorithm>
#include <bit>
#include <cmath>

#include "playhouse/bodies/polygon_hit.h"
#include "playhouse/rays/bundle.h"
#include "playhouse/rays/march.h"
#include "playhouse/rays/measure.h"
#include "playhouse/simd/vectors.h"

namespace playhouse::rays {
namespace {

/// Appends the rays of a bundle in W, as this part.
PLAYHOUSE_INLINE void put_rays(const Bundle& bundle, const geom::Pose& X_WM, geom::Rotation r,
                               std::size_t first_beam, const Rays::NearRays& part, Rays& rays) {
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
    rays.solid[first + k] = bodies::kNoSolid;
    rays.beam[first + k] = first_beam + bundle.beam[k];
  }
  rays.count = part.end;
  rays.parts[rays.part_count++] = part;
}

/// find_bodies() for rays beyond the exact range of DiscIndex units: takes all bodies visible to rangers.
std::size_t take_all(const Bundle& bundle, const bodies::DiscIndex& index,
                     std::span<const bodies::DiscIndex::Run> runs, world::ModelRow own_root,
                     const NearBodies& out) {
  std::size_t count = 0;
  for (const bodies::DiscIndex::Run& run : runs) {
    for (std::uint32_t place = run.begin; place < run.end; ++place) {
      const bodies::DiscIndex::Disc& disc = index.discs()[place];
      if ((disc.seen_by & bit(bodies::SeenBy::kRanger)) == 0 || disc.root == own_root) continue;
      out.place[count] = place;
      out.rays[count++] = static_cast<std::uint16_t>((1u << bundle.rays()) - 1);
    }
  }
  return count;
}

/// Shortens the rays of a part by their hits with an edge.
PLAYHOUSE_INLINE void meet_edge(geom::Vec2 a, geom::Vec2 b, double row, const Rays::NearRays& part,
                                Rays& rays) {
  simd::Mask4 edge_on = {};
  std::size_t k = part.begin;
  for (; k + simd::kFour <= part.end; k += simd::kFour) {
    simd::Double4 px, py, dx, dy, range, solid;
    simd::load(px, rays.px + k);
    simd::load(py, rays.py + k);
    simd::load(dx, rays.dx + k);
    simd::load(dy, rays.dy + k);
    simd::load(range, rays.range + k);
    simd::load(solid, rays.solid + k);
    const bodies::Distance<simd::Double4, simd::Double4> met(dx, dy, a.x - px, a.y - py, b.x - px, b.y - py);
    edge_on |= met.edge_on;
    bodies::keep_first(met.t, simd::Double4{row, row, row, row}, range, solid);
    simd::store(rays.range + k, range);
    simd::store(rays.solid + k, solid);
  }
  for (k = simd::any(edge_on) ? part.begin : k; k < part.end; ++k)
    bodies::keep_first(bodies::edge_hit(a - rays.p(k), b - rays.p(k), rays.d(k)), row, rays.range[k],
                       rays.solid[k]);
}

void meet_few_walls(const bodies::Space& space, const Rays::NearRays& part, Rays& rays) {
  const geom::Box box = bodies::box_about(part.about, part.reach);
  for (const bodies::Walls::Edge& edge : space.walls.few())
    if (edge.reaches(box) && RangerView::sees(space.solids, edge.solid, part.root, rays.z[part.begin]))
      simd::in_vectors<meet_edge>(edge.a, edge.b, bodies::number_of(edge.solid), part, rays);
}

}  // namespace

void meet_walls_alone(const bodies::Space& space, const Rays::NearRays& part, Rays& rays) {
  for (std::size_t k = part.begin; k < part.end; ++k) {
    const geom::Vec2 p = rays.p(k), d = rays.d(k);
    space.walls.along(p, d, &rays.range[k], [&](const bodies::Walls::Edge& edge) {
      if (!RangerView::sees(space.solids, edge.solid, part.root, rays.z[k])) return;
      const double t = bodies::edge_hit(edge.a - p, edge.b - p, d);
      bodies::keep_first(t, bodies::number_of(edge.solid), rays.range[k], rays.solid[k]);
    });
  }
}

void run_bundle(const bodies::Space& space, const RangerView& view, const Bundle& bundle, Scratch& scratch) {
  if (scratch.rays.count + bundle.rays() > Rays::kMost) finish_rays(space, scratch);
  Rays& rays = scratch.rays;
  const Rays::NearRays part{view.X_WM.xy(), rays.count,   rays.count + bundle.rays(),  bundle.reach,
                            view.root,      view.is_wall, bundle.z_min == bundle.z_max};
  simd::in_vectors<put_rays>(bundle, view.X_WM, view.rotation, scratch.first_beam, part, rays);
  const double z_low = view.X_WM.z + bundle.z_min, z_high = view.X_WM.z + bundle.z_max;
  const Heights heights{z_low, z_high, space.index.is_all_seen(z_low, z_high)};
  const NearBodies near{scratch.place.data(), scratch.cell.data(), scratch.met_by.data()};
  for (std::size_t size = 0; size < space.index.radii().size(); ++size) {
    const std::span<const bodies::DiscIndex::Run> runs =
        space.index.find_runs(size, view.X_WM.xy(), bundle.reach, z_low, z_high, scratch.runs);
    if (runs.empty()) continue;
    const Bundle::Table& table = bundle.tables[size];
    const std::size_t count = table.half < bodies::DiscIndex::kFarthest
                                  ? find_bodies(table, space.index.places(), runs, view.X_WM.xy(),
                                                view.rotation, view.root.index, heights, near)
                                  : take_all(bundle, space.index, runs, view.root, near);
    add_pairs(space, near, count, part.begin, heights, rays, scratch.pairs);
  }
}

bool can_march(const bodies::Walls& walls, const Rays::NearRays& part) {
  return !part.is_wall && part.reach < kFarthestMarch * walls.torus().cell();
}

// Bodies come first, which shortens the rays for the walls.
void finish_rays(const bodies::Space& space, Scratch& scratch) {
  Rays& rays = scratch.rays;
  if (rays.count == 0) return;
  resolve_pairs(space, rays, scratch.pairs);
  std::size_t marching = 0;
  for (std::size_t i = 0; i < rays.part_count; ++i) {
    const Rays::NearRays part = rays.parts[i];
    if (space.walls.clear_about(part.about) > part.reach) continue;
    if (!space.walls.few().empty() && part.is_level)
      meet_few_walls(space, part, rays);
    else if (can_march(space.walls, part))
      rays.parts[marching++] = part;
    else
      meet_walls_alone(space, part, rays);
  }
  rays.part_count = marching;
  if (marching > 0) march(space.walls, RangerView::kBy, rays);
  for (std::size_t k = 0; k < rays.count; ++k) {
    scratch.range[rays.beam[k]] = rays.range[k];
    scratch.solid[rays.beam[k]] = rays.solid[k];
  }
  rays.count = rays.part_count = 0;
}

}  // namespace playhouse::rays
