/// Bundles: the single rays of a ranger, looked at together. Walls come first: what they hide need not be
/// looked at.

#include <algorithm>
#include <bit>
#include <cmath>

#include "playhouse/stage/march.h"
#include "playhouse/stage/sense_ranger.h"
#include "playhouse/stage/vectors.h"

namespace playhouse::stage {
namespace {

/// The rays of a bundle in W, as they get shorter.
struct Rays {
  double px[Bundle::kRays], py[Bundle::kRays], dx[Bundle::kRays], dy[Bundle::kRays];
  double range[Bundle::kRays], intensity[Bundle::kRays];

  Vec2 p(std::size_t k) const { return {px[k], py[k]}; }
  Vec2 d(std::size_t k) const { return {dx[k], dy[k]}; }
};

PLAYHOUSE_VECTORS void put_rays(const Bundle& bundle, Vec2 p_WM, Rotation r, Rays& rays) {
  const std::size_t count = bundle.rays();
  const double *px = bundle.p.x.data(), *py = bundle.p.y.data(), *dx = bundle.d.x.data(),
               *dy = bundle.d.y.data();
  for (std::size_t k = 0; k < count; ++k) {
    rays.px[k] = p_WM.x + (r.c * px[k] - r.s * py[k]);
    rays.py[k] = p_WM.y + (r.s * px[k] + r.c * py[k]);
    rays.dx[k] = r.c * dx[k] - r.s * dy[k];
    rays.dy[k] = r.s * dx[k] + r.c * dy[k];
    rays.range[k] = bundle.range_max[k];
    rays.intensity[k] = 0;
  }
}

/// Keeps the nearer of what is known and the edge, for all rays.
PLAYHOUSE_VECTORS void meet_edge(Vec2 a, Vec2 b, double seen, std::size_t count, Rays& rays) {
  for (std::size_t k = 0; k < count; ++k) {
    const double ax = a.x - rays.px[k], ay = a.y - rays.py[k], bx = b.x - rays.px[k], by = b.y - rays.py[k];
    const double s0 = rays.dx[k] * ay - rays.dy[k] * ax, s1 = rays.dx[k] * by - rays.dy[k] * bx;
    const double t = (ax * by - ay * bx) / (s1 - s0);
    const bool met = ((s0 <= 0) & (s1 >= 0)) | ((s0 >= 0) & (s1 <= 0));
    const bool nearer = met & (t >= 0) & (t < rays.range[k]);
    rays.range[k] = nearer ? t : rays.range[k];
    rays.intensity[k] = nearer ? seen : rays.intensity[k];
  }
}

/// edge_hit() without branches.
inline double quick_hit(Vec2 w0, Vec2 w1, Vec2 d) {
  const double s0 = geom::cross(d, w0), s1 = geom::cross(d, w1);
  const double t = geom::cross(w0, w1) / (s1 - s0);
  const bool met = (((s0 <= 0) & (s1 >= 0)) | ((s0 >= 0) & (s1 <= 0))) & (t >= 0);
  return met ? t : kMiss;
}

/// Turns centres into the ranger's frame and finds their cells in `meets`.
PLAYHOUSE_VECTORS void find_cells(const Bundle& bundle, Rotation r, std::size_t count, double* __restrict x,
                                  double* __restrict y, std::int32_t* __restrict cell) {
  constexpr double kLast = static_cast<double>(Bundle::kSide) - 1;
  const double per_cell = 1.0 / bundle.cell, middle = bundle.half * per_cell + 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double u = r.c * x[i] + r.s * y[i], v = r.c * y[i] - r.s * x[i];
    x[i] = u;
    y[i] = v;
    double column = u * per_cell + middle, row = v * per_cell + middle;
    column = column < 0 ? 0 : column > kLast ? kLast : column;
    row = row < 0 ? 0 : row > kLast ? kLast : row;
    cell[i] = static_cast<std::int32_t>(row) * static_cast<std::int32_t>(Bundle::kSide) +
              static_cast<std::int32_t>(column);
  }
}

}  // namespace

void RangerSense::run_bundle(const Space& space, const View& view, const Bundle& bundle, Bench& bench) {
  const Solids& solids = space.solids;
  const Vec2 p_WM = view.X_WM.xy();
  const Rotation rotation = Rotation::of(view.X_WM.a);
  Rays rays;
  put_rays(bundle, p_WM, rotation, rays);
  const auto keep = [&](std::size_t k, double t, std::uint32_t row) {
    if (t >= rays.range[k] || !view.sees(solids, row) || !at_height(solids, row, view.X_WM.z + bundle.z[k]))
      return;
    rays.range[k] = t;
    rays.intensity[k] = solids.ranger_return[row];
  };

  const double z_low = view.X_WM.z + bundle.z_min, z_high = view.X_WM.z + bundle.z_max;
  if (!space.walls.few().empty() && z_low == z_high) {  // each edge for all rays
    const geom::Box box = box_about(p_WM, bundle.reach);
    for (const Walls::Edge& edge : space.walls.few())
      if (edge.reaches(box) && view.sees(solids, edge.solid) && at_height(solids, edge.solid, z_low))
        meet_edge(edge.a, edge.b, solids.ranger_return[edge.solid], bundle.rays(), rays);
  } else if (space.walls.edge_count() > 0) {
    const auto try_edges = [&](std::size_t k, std::span<const Walls::Edge> edges) {
      const Vec2 p = rays.p(k), d = rays.d(k);
      double nearest = rays.range[k];
      for (const Walls::Edge& edge : edges) nearest = std::min(nearest, quick_hit(edge.a - p, edge.b - p, d));
      if (nearest >= rays.range[k]) return;  // by far most often; else find out which one it was
      for (const Walls::Edge& edge : edges) keep(k, quick_hit(edge.a - p, edge.b - p, d), edge.solid);
    };
    if (bundle.reach < March::kFarthest * space.walls.torus().cell()) {
      march_along(space.walls, bundle.rays(), p_WM, rays.px, rays.py, rays.dx, rays.dy, rays.range,
                  try_edges);
    } else {
      for (std::size_t k = 0; k < bundle.rays(); ++k)
        space.walls.along(rays.p(k), rays.d(k), &rays.range[k], [&](const Walls::Edge& edge) {
          try_edges(k, {&edge, 1});
        });
    }
  }

  const std::size_t count = bench.gather(space.index, {p_WM, bundle.reach, z_low, z_high});
  find_cells(bundle, rotation, count, bench.x.data(), bench.y.data(), bench.cell.data());
  std::size_t matter = 0;
  for (std::size_t i = 0; i < count; ++i) {
    bench.order[matter] = static_cast<std::uint32_t>(i);
    matter += bundle.meets[static_cast<std::size_t>(bench.cell[i])] != 0;
  }
  for (std::size_t n = 0; n < matter; ++n) {
    const std::size_t i = bench.order[n];
    std::uint64_t near = bundle.meets[static_cast<std::size_t>(bench.cell[i])];
    const DiscIndex::Disc& disc = space.index.discs()[bench.place[i]];
    if (!view.sees(disc)) continue;
    const double radius = disc.radius + kMargin;
    for (; near != 0; near &= near - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(near));
      const Vec2 d = bundle.d[k], to_disc = Vec2{bench.x[i], bench.y[i]} - bundle.p[k];
      const double ahead = geom::dot(d, to_disc);
      if ((std::fabs(geom::cross(d, to_disc)) > radius) | (ahead < -radius) |
          (ahead - radius > rays.range[k]))
        continue;
      keep(k, polygon_hit(solids.p.data() + disc.first_vertex, disc.vertices, rays.p(k), rays.d(k)),
           disc.row);
    }
  }

  for (std::size_t k = 0; k < bundle.rays(); ++k) {
    bench.range[bundle.beam[k]] = rays.range[k];
    bench.intensity[bundle.beam[k]] = rays.intensity[k];
  }
}

}  // namespace playhouse::stage
