/// Scans: instead of tracing each beam, nearby bodies are projected onto the beams they
/// cover, and the nearest hit is kept (a one-dimensional depth buffer). The range of beams
/// that a body may cover comes from a conservative bearing; hits are exact. Bodies are
/// sorted front to back, so that most occluded ones are rejected by an early depth test.

#include <algorithm>
#include <cmath>

#include "playhouse/rays/bearing.h"
#include "playhouse/rays/march.h"
#include "playhouse/rays/measure.h"
#include "playhouse/rays/scan.h"
#include "playhouse/rays/scan_kernels.h"

namespace playhouse::rays {
namespace {

/// Rotates beams into W; the pad is NaN and stays so.
PLAYHOUSE_INLINE void turn_beams(geom::Rotation r, std::size_t count, const double* __restrict x_S,
                                 const double* __restrict y_S, double* __restrict x, double* __restrict y) {
  for (std::size_t k = 0; k < count; ++k) {
    x[k] = r.c * x_S[k] - r.s * y_S[k];
    y[k] = r.s * x_S[k] + r.c * y_S[k];
  }
}

/// Projects the edge from w0 to w1, which is right of w0 and seen edge-on by
/// no beam, onto beams `first` to `last`, and a few more (the pad).
PLAYHOUSE_INLINE void project(const ScanBeams& row, geom::Vec2 w0, geom::Vec2 w1, double seen,
                              std::size_t first, std::size_t last) {
  const double area = geom::cross(w0, w1);
  for (std::size_t k = first; k <= last; k += simd::kFour) {
    simd::Double4 x, y, range, solid;
    simd::load(x, row.x + k);
    simd::load(y, row.y + k);
    simd::load(range, row.range + k);
    simd::load(solid, row.solid + k);
    const bodies::Crossing<simd::Double4> ends({x, y, w0.x, w0.y}, {x, y, w1.x, w1.y});
    bodies::keep_first<simd::Double4>(ends.enters ? area / ends.slope : bodies::kMiss,
                                      simd::Double4{seen, seen, seen, seen}, range, solid);
    simd::store(row.range + k, range);
    simd::store(row.solid + k, solid);
  }
}

/// An edge collinear with the scanner: all beams, scalar.
void project_in_line(const ScanBeams& row, geom::Vec2 w0, geom::Vec2 w1, double seen) {
  for (std::size_t k = 0; k <= row.last; ++k)
    bodies::keep_first(bodies::edge_hit(w0, w1, {row.x[k], row.y[k]}), seen, row.range[k], row.solid[k]);
}

/// Calls visit(first, last) for the beams that cover a bearing
/// interval, once for each full turn in which it overlaps the fov.
template <typename Visit>
void each_turn(const ScanBeams& row, double from, double to, const Visit& visit) {
  const auto turns = static_cast<int>(row.half / geom::kTwoPi) + 1;
  for (int turn = -turns; turn <= turns; ++turn) {
    const double low = from + turn * geom::kTwoPi, high = to + turn * geom::kTwoPi;
    if (high < -row.half || low > row.half) continue;
    visit(row.beam_right_of(low), row.beam_left_of(high));
  }
}

void project_edge(geom::Vec2 w0, geom::Vec2 w1, geom::Rotation rotation, double seen, const ScanBeams& row) {
  const double area = geom::cross(w0, w1);
  if (std::fabs(area) <=
      bodies::kEdgeOn * (std::fabs(w0.x) + std::fabs(w0.y) + std::fabs(w1.x) + std::fabs(w1.y))) {
    project_in_line(row, w0, w1, seen);
    return;
  }
  if (area > 0) std::swap(w0, w1);
  const double from = rough_bearing(rotation.inverse(w1)) - kBearingError;
  double to = rough_bearing(rotation.inverse(w0)) + kBearingError;
  if (to < from - 3.0) to += geom::kTwoPi;
  each_turn(row, from, to, [&](std::size_t first, std::size_t last) {
    simd::in_vectors<project>(row, w0, w1, seen, first, last);
  });
}

/// A body of any shape, seen from anywhere, edge by edge.
void project_edges(std::span<const geom::Vec2> polygon, geom::Rotation rotation, double seen,
                   const ScanBeams& row) {
  geom::Vec2 before = polygon.back() - row.p;
  for (const geom::Vec2 corner : polygon) {
    const geom::Vec2 w = corner - row.p;
    project_edge(before, w, rotation, seen, row);
    before = w;
  }
}

/// Fills the batch with beams from `first` on, as this part.
void put_beams(const ScanBeams& row, double range_max, double z, std::size_t first, Rays::NearRays part,
               Rays& rays) {
  rays.count = part.end = std::min(row.last + 1 - first, Rays::kMost);
  rays.parts[0] = part;
  rays.part_count = 1;
  for (std::size_t k = 0; k < rays.count; ++k) {
    rays.px[k] = row.p.x;
    rays.py[k] = row.p.y;
    rays.dx[k] = row.x[first + k];
    rays.dy[k] = row.y[first + k];
    rays.z[k] = z;
    rays.range[k] = range_max;
    rays.solid[k] = bodies::kNoSolid;
  }
}

/// Rotates centers into the scanner's frame; computes distances and approximate bearings.
PLAYHOUSE_INLINE void find_distances(geom::Rotation r, std::size_t count, double* __restrict x,
                                     double* __restrict y, double* __restrict distance,
                                     double* __restrict bearing) {
  for (std::size_t i = 0; i < count; ++i) {
    const double u = r.c * x[i] + r.s * y[i], v = r.c * y[i] - r.s * x[i];
    x[i] = u;
    y[i] = v;
    distance[i] = std::sqrt(u * u + v * v);
    bearing[i] = rough_bearing({u, v});
  }
}

/// Half of the angular extent of a circle, by the ratio of radius
/// and distance: at least asin(ratio) + kBearingError. [rad]
template <typename Number>
PLAYHOUSE_INLINE void find_spread(const Number& ratio, Number& spread) {
  spread = ratio + 0.5708 * ratio * ratio * ratio + kBearingError;
}

/// Conservative range of beams for each body, by its radius, distance and
/// bearing: `last` is -1 if a cheap bound fails, and the distance becomes kMiss
/// if no beam can hit. Vectors of four: writes a pad of up to three entries.
PLAYHOUSE_INLINE void find_beams(const ScanBeams& row, std::size_t count, const double* radius,
                                 const double* bearing, double* distance, std::int32_t* first,
                                 std::int32_t* last) {
  const double end = static_cast<double>(row.last);
  const double most = row.half <= geom::kPi ? geom::kPi : -bodies::kMiss;  // others may meet a body twice
  for (std::size_t i = 0; i < count; i += simd::kFour) {
    simd::Double4 size, middle, apart;
    simd::load(size, radius + i);
    simd::load(middle, bearing + i);
    simd::load(apart, distance + i);
    const simd::Double4 ratio = size / apart;
    simd::Double4 spread;
    find_spread(ratio, spread);
    const simd::Double4 from = middle - spread, to = middle + spread;
    const auto easy = (ratio < 1) & (from > -geom::kPi) & (to < most);
    simd::Double4 right = (from + row.half) * row.per_step, left = (to + row.half) * row.per_step;
    right = right > 0 ? right : 0;
    right = right < end ? right : end;
    left = left > 0 ? left : 0;
    left = left < end ? left : end;
    left = __builtin_convertvector(__builtin_convertvector(left, simd::Int4), simd::Double4) + 1;
    left = left < end ? left : end;
    left = easy ? left : -1;
    simd::store(first + i, __builtin_convertvector(right, simd::Int4));
    simd::store(last + i, __builtin_convertvector(left, simd::Int4));
    simd::store<simd::Double4>(distance + i,
                               (easy & ((to < -row.half) | (from > row.half))) ? bodies::kMiss : apart);
  }
}

/// Sorts candidates that are no kMiss front to back into `order` by rings of distance, those beyond `reach`
/// last (counting sort); returns their number.
std::size_t sort_by_distance(std::size_t count, double reach, Scratch& scratch) {
  constexpr std::size_t kRings = 32;
  std::uint32_t first[kRings + 2] = {};
  const double per_ring = static_cast<double>(kRings) / reach;
  const double* const far = scratch.distance.data();
  std::int32_t* const ring = scratch.ring.data();
  for (std::size_t i = 0; i < count; ++i) {
    const double at = std::min(far[i] * per_ring, static_cast<double>(kRings - 1));
    ring[i] = static_cast<std::int32_t>(far[i] < bodies::kMiss ? at : static_cast<double>(kRings));
  }
  for (std::size_t i = 0; i < count; ++i) ++first[ring[i] + 1];
  for (std::size_t r = 1; r <= kRings; ++r) first[r] += first[r - 1];
  const std::size_t seen = first[kRings];
  std::uint32_t* const sorted = scratch.order.data();
  for (std::size_t i = 0; i < count; ++i)
    if (ring[i] < static_cast<std::int32_t>(kRings)) sorted[first[ring[i]]++] = static_cast<std::uint32_t>(i);
  return seen;
}

void scan_bodies(const bodies::Space& space, const geom::Pose& X_WS, geom::Rotation rotation, double z,
                 const RangerView& view, const Scan& scan, Scratch& scratch) {
  const bodies::Solids& solids = space.solids;
  const ScanBeams row(scan, X_WS.xy(), scratch.beam_x.data(), scratch.beam_y.data(),
                      scratch.range.data() + scratch.first_beam, scratch.solid.data() + scratch.first_beam);
  Sector sector{X_WS.xy(), scan.range_max + bodies::kMargin, z, {0, 0}, 0};
  // No beam points backwards: culls what is entirely behind.
  const bool is_ahead = scan.fov <= geom::kPi;
  if (is_ahead) sector.ahead = {rotation.c, rotation.s};
  std::size_t near = 0;
  for (std::size_t size = 0; size < space.index.radii().size(); ++size) {
    const double radius_max = space.index.radii()[size];
    if (is_ahead) sector.behind = -radius_max - bodies::kMargin;
    const std::span<const bodies::DiscIndex::Run> runs =
        space.index.find_runs(size, sector.p, sector.reach, z, z, scratch.runs);
    if (runs.empty()) continue;
    near += simd::in_vectors<gather>(
        sector, radius_max, space.index.places(), runs,
        Gathered{scratch.x.data() + near, scratch.y.data() + near, scratch.place.data() + near});
  }
  const bodies::DiscIndex::Disc* const discs = space.index.discs();
  for (std::size_t i = 0; i < near; ++i) scratch.radius[i] = discs[scratch.place[i]].radius + bodies::kMargin;
  simd::in_vectors<find_distances>(rotation, near, scratch.x.data(), scratch.y.data(),
                                   scratch.distance.data(), scratch.bearing.data());
  simd::in_vectors<find_beams>(row, near, scratch.radius.data(), scratch.bearing.data(),
                               scratch.distance.data(), scratch.first.data(), scratch.last.data());
  const std::size_t count = sort_by_distance(near, scan.range_max + space.index.radii()[0], scratch);

  constexpr std::size_t kAhead = 3;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t at = scratch.order[i];
    const bodies::DiscIndex::Disc& disc = discs[scratch.place[at]];
    if (i + kAhead < count) {
      const geom::Vec2* const soon =
          solids.p.from(discs[scratch.place[scratch.order[i + kAhead]]].first_vertex);
      __builtin_prefetch(soon);
      __builtin_prefetch(soon + 4);
      __builtin_prefetch(soon + 8);
    }
    if (!view.sees(disc)) continue;
    const double distance = scratch.distance[at], radius = scratch.radius[at];
    const std::span<const geom::Vec2> polygon(solids.p.from(disc.first_vertex), disc.vertices);
    const auto seen = bodies::number_of(disc.solid());
    if (disc.convex == 0) {
      project_edges(polygon, rotation, seen, row);
    } else if (scratch.last[at] >= 0) {
      simd::in_vectors<project_facing>(row, polygon.data(), polygon.size(), seen, distance - radius,
                                       distance + radius, static_cast<std::size_t>(scratch.first[at]),
                                       static_cast<std::size_t>(scratch.last[at]));
    } else if (radius < distance) {
      const double bearing = scratch.bearing[at];
      double spread;
      find_spread(radius / distance, spread);
      each_turn(row, bearing - spread, bearing + spread, [&](std::size_t first, std::size_t last) {
        simd::in_vectors<project_body>(row, polygon.data(), polygon.size(), seen, first, last);
      });
    } else {
      simd::in_vectors<project_body>(row, polygon.data(), polygon.size(), seen, 0, row.last);
    }
  }
}

void scan_walls(const bodies::Space& space, const geom::Pose& X_WS, geom::Rotation rotation, double z,
                const RangerView& view, const Scan& scan, Scratch& scratch) {
  if (space.walls.clear_about(X_WS.xy()) > scan.range_max) return;
  const geom::Box box = bodies::box_about(X_WS.xy(), scan.range_max + bodies::kMargin);
  const ScanBeams row(scan, X_WS.xy(), scratch.beam_x.data(), scratch.beam_y.data(),
                      scratch.range.data() + scratch.first_beam, scratch.solid.data() + scratch.first_beam);
  const auto hides = [&](bodies::SolidRow solid) { return view.sees(space.solids, solid, z); };
  const auto project_wall = [&](const bodies::Walls::Edge& edge) {
    project_edge(edge.a - row.p, edge.b - row.p, rotation, bodies::number_of(edge.solid), row);
  };
  if (!space.walls.few().empty()) {
    for (const bodies::Walls::Edge& edge : space.walls.few())
      if (edge.reaches(box) && hides(edge.solid)) project_wall(edge);
    return;
  }
  if (space.walls.count_near(box) <= scan.count) {
    ++scratch.scans;
    space.walls.near(box, [&](const bodies::Walls::Edge& edge) {
      if (scratch.stamp[edge.row] == scratch.scans) return;
      scratch.stamp[edge.row] = scratch.scans;
      if (hides(edge.solid)) project_wall(edge);
    });
    return;
  }
  // With this many edges, tracing the beams is cheaper.
  Rays rays;
  const Rays::NearRays part{row.p, 0, 0, scan.range_max, view.root, view.is_wall, true};
  const bool marches = can_march(space.walls, part);
  for (std::size_t first = 0; first < scan.count; first += Rays::kMost) {
    put_beams(row, scan.range_max, z, first, part, rays);
    if (marches)
      march(space.walls, bit(bodies::SeenBy::kRanger), rays);
    else
      meet_walls_alone(space, rays.parts[0], rays);
    std::copy_n(rays.range, rays.count, row.range + first);
    std::copy_n(rays.solid, rays.count, row.solid + first);
  }
}

}  // namespace

void run_scan(const bodies::Space& space, const RangerView& view, const Scan& scan, Scratch& scratch) {
  std::fill_n(scratch.range.begin() + scratch.first_beam + scan.first_beam, scan.count, scan.range_max);
  const geom::Pose X_WS = geom::compose(view.X_WM, scan.X_MS);
  const double z = view.X_WM.z + scan.z;
  const geom::Rotation rotation = geom::Rotation::of(X_WS.a);
  simd::in_vectors<turn_beams>(rotation, scan.x.size(), scan.x.data(), scan.y.data(), scratch.beam_x.data(),
                               scratch.beam_y.data());
  scan_walls(space, X_WS, rotation, z, view, scan, scratch);
  scan_bodies(space, X_WS, rotation, z, view, scan, scratch);
}

}  // namespace playhouse::rays
