/// Scans: instead of tracing each beam, nearby bodies are projected onto the beams they
/// cover, and the nearest hit is kept (a one-dimensional depth buffer). The range of beams
/// that a body may cover comes from a conservative bearing; hits are exact. Bodies are
/// sorted front to back, so that most occluded ones are rejected by an early depth test.

#include <algorithm>
#include <cmath>

#include "playhouse/stage/bearing.h"
#include "playhouse/stage/march.h"
#include "playhouse/stage/scan.h"
#include "playhouse/stage/sense_ranger.h"
#include "playhouse/stage/wide.h"

namespace playhouse::stage {
namespace {

/// Rotates beams into W; padding is NaN and stays so.
PLAYHOUSE_INLINE void turn_beams(Rotation r, std::size_t count, const double* __restrict x_S,
                                 const double* __restrict y_S, double* __restrict x, double* __restrict y) {
  for (std::size_t k = 0; k < count; ++k) {
    x[k] = r.c * x_S[k] - r.s * y_S[k];
    y[k] = r.s * x_S[k] + r.c * y_S[k];
  }
}

/// Projects the edge from w0 to w1, which is right of w0 and seen edge-on by
/// no beam, onto beams `first` to `last`, and a few more (vector padding).
PLAYHOUSE_INLINE void project(const Row& row, Vec2 w0, Vec2 w1, double seen, std::size_t first,
                              std::size_t last) {
  const double area = geom::cross(w0, w1);
  for (std::size_t k = first; k <= last; k += kFour) {
    Four x, y, range, solid;
    load(x, row.x + k);
    load(y, row.y + k);
    load(range, row.range + k);
    load(solid, row.solid + k);
    const Crossing<Four> ends({x, y, w0.x, w0.y}, {x, y, w1.x, w1.y});
    keep_first<Four>(ends.enters ? area / ends.slope : kMiss, Four{seen, seen, seen, seen}, range, solid);
    store(row.range + k, range);
    store(row.solid + k, solid);
  }
}

/// An edge collinear with the scanner: all beams, scalar.
void project_in_line(const Row& row, Vec2 w0, Vec2 w1, double seen) {
  for (std::size_t k = 0; k <= row.last; ++k)
    keep_first(edge_hit(w0, w1, {row.x[k], row.y[k]}), seen, row.range[k], row.solid[k]);
}

/// Calls visit(first, last) for the beams that cover a bearing
/// interval, once for each full turn in which it overlaps the fov.
template <typename Visit>
void each_turn(const Row& row, double from, double to, const Visit& visit) {
  const auto turns = static_cast<int>(row.half / geom::kTwoPi) + 1;
  for (int turn = -turns; turn <= turns; ++turn) {
    const double low = from + turn * geom::kTwoPi, high = to + turn * geom::kTwoPi;
    if (high < -row.half || low > row.half) continue;
    visit(row.beam_right_of(low), row.beam_left_of(high));
  }
}

void project_edge(Vec2 w0, Vec2 w1, Rotation rotation, double seen, const Row& row) {
  const double area = geom::cross(w0, w1);
  if (std::fabs(area) <= kEdgeOn * (std::fabs(w0.x) + std::fabs(w0.y) + std::fabs(w1.x) + std::fabs(w1.y))) {
    project_in_line(row, w0, w1, seen);
    return;
  }
  if (area > 0) std::swap(w0, w1);
  const double from = rough_bearing(rotation.inverse(w1)) - kBearingError;
  double to = rough_bearing(rotation.inverse(w0)) + kBearingError;
  if (to < from - 3.0) to += geom::kTwoPi;
  each_turn(row, from, to, [&](std::size_t first, std::size_t last) {
    in_vectors<project>(row, w0, w1, seen, first, last);
  });
}

/// A body of any shape, seen from anywhere, edge by edge.
void project_edges(std::span<const Vec2> polygon, Rotation rotation, double seen, const Row& row) {
  Vec2 before = polygon.back() - row.p;
  for (const Vec2 corner : polygon) {
    const Vec2 w = corner - row.p;
    project_edge(before, w, rotation, seen, row);
    before = w;
  }
}

/// Fills the batch with beams from `first` on, as this part.
void put_beams(const Row& row, double range_max, double z, std::size_t first, Rays::Part part, Rays& rays) {
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
    rays.solid[k] = kNoSolid;
  }
}

/// Rotates centers into the scanner's frame; computes distances and approximate bearings.
PLAYHOUSE_INLINE void find_distances(Rotation r, std::size_t count, double* __restrict x,
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
/// if no beam can hit. Vectors of four: writes up to three entries of padding.
PLAYHOUSE_INLINE void find_beams(const Row& row, std::size_t count, const double* radius,
                                 const double* bearing, double* distance, std::int32_t* first,
                                 std::int32_t* last) {
  const double end = static_cast<double>(row.last);
  const double most = row.half <= geom::kPi ? geom::kPi : -kMiss;  // others may meet a body twice
  for (std::size_t i = 0; i < count; i += kFour) {
    Four size, middle, apart;
    load(size, radius + i);
    load(middle, bearing + i);
    load(apart, distance + i);
    const Four ratio = size / apart;
    Four spread;
    find_spread(ratio, spread);
    const Four from = middle - spread, to = middle + spread;
    const auto easy = (ratio < 1) & (from > -geom::kPi) & (to < most);
    Four right = (from + row.half) * row.per_step, left = (to + row.half) * row.per_step;
    right = right > 0 ? right : 0;
    right = right < end ? right : end;
    left = left > 0 ? left : 0;
    left = left < end ? left : end;
    left = __builtin_convertvector(__builtin_convertvector(left, FourInts), Four) + 1;
    left = left < end ? left : end;
    left = easy ? left : -1;
    store(first + i, __builtin_convertvector(right, FourInts));
    store(last + i, __builtin_convertvector(left, FourInts));
    store<Four>(distance + i, (easy & ((to < -row.half) | (from > row.half))) ? kMiss : apart);
  }
}

}  // namespace

/// Sorts candidates that are no kMiss front to back into `order` by rings of distance, those beyond `reach`
/// last (counting sort); returns their number.
std::size_t RangerSense::Scratch::sort_by_distance(std::size_t count, double reach) {
  constexpr std::size_t kRings = 32;
  std::uint32_t first[kRings + 2] = {};
  const double per_ring = static_cast<double>(kRings) / reach;
  const double* const far = distance.data();
  std::int32_t* const ring = this->ring.data();
  for (std::size_t i = 0; i < count; ++i) {
    const double at = std::min(far[i] * per_ring, static_cast<double>(kRings - 1));
    ring[i] = static_cast<std::int32_t>(far[i] < kMiss ? at : static_cast<double>(kRings));
  }
  for (std::size_t i = 0; i < count; ++i) ++first[ring[i] + 1];
  for (std::size_t r = 1; r <= kRings; ++r) first[r] += first[r - 1];
  const std::size_t seen = first[kRings];
  std::uint32_t* const sorted = order.data();
  for (std::size_t i = 0; i < count; ++i)
    if (ring[i] < static_cast<std::int32_t>(kRings)) sorted[first[ring[i]]++] = static_cast<std::uint32_t>(i);
  return seen;
}

void RangerSense::scan_bodies(const Space& space, const Pose& X_WS, Rotation rotation, double z,
                              const View& view, const Scan& scan, Scratch& scratch) {
  const Solids& solids = space.solids;
  const Row row(scan, X_WS.xy(), scratch.beam_x.data(), scratch.beam_y.data(),
                scratch.range.data() + scratch.first_beam, scratch.solid.data() + scratch.first_beam);
  Sector sector{X_WS.xy(), scan.range_max + kMargin, z, {0, 0}, 0};
  // No beam points backwards: culls what is entirely behind.
  const bool is_ahead = scan.fov <= geom::kPi;
  if (is_ahead) sector.ahead = {rotation.c, rotation.s};
  std::size_t near = 0;
  for (std::size_t size = 0; size < space.index.radii().size(); ++size) {
    const double radius_max = space.index.radii()[size];
    if (is_ahead) sector.behind = -radius_max - kMargin;
    const std::span<const DiscIndex::Run> runs =
        space.index.find_runs(size, sector.p, sector.reach, z, z, scratch.runs);
    if (runs.empty()) continue;
    near += in_vectors<gather>(
        sector, radius_max, space.index.places(), runs,
        Gathered{scratch.x.data() + near, scratch.y.data() + near, scratch.place.data() + near});
  }
  const DiscIndex::Disc* const discs = space.index.discs();
  for (std::size_t i = 0; i < near; ++i) scratch.radius[i] = discs[scratch.place[i]].radius + kMargin;
  in_vectors<find_distances>(rotation, near, scratch.x.data(), scratch.y.data(), scratch.distance.data(),
                             scratch.bearing.data());
  in_vectors<find_beams>(row, near, scratch.radius.data(), scratch.bearing.data(), scratch.distance.data(),
                         scratch.first.data(), scratch.last.data());
  const std::size_t count = scratch.sort_by_distance(near, scan.range_max + space.index.radii()[0]);

  constexpr std::size_t kAhead = 3;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t at = scratch.order[i];
    const DiscIndex::Disc& disc = discs[scratch.place[at]];
    if (i + kAhead < count) {
      const Vec2* const soon = solids.p.data() + discs[scratch.place[scratch.order[i + kAhead]]].first_vertex;
      __builtin_prefetch(soon);
      __builtin_prefetch(soon + 4);
      __builtin_prefetch(soon + 8);
    }
    if (!view.sees(disc)) continue;
    const double distance = scratch.distance[at], radius = scratch.radius[at];
    const std::span<const Vec2> polygon(solids.p.data() + disc.first_vertex, disc.vertices);
    const auto seen = number_of(disc.row);
    if (disc.convex == 0) {
      project_edges(polygon, rotation, seen, row);
    } else if (scratch.last[at] >= 0) {
      in_vectors<project_facing>(row, polygon.data(), polygon.size(), seen, distance - radius,
                                 distance + radius, static_cast<std::size_t>(scratch.first[at]),
                                 static_cast<std::size_t>(scratch.last[at]));
    } else if (radius < distance) {
      const double bearing = scratch.bearing[at];
      double spread;
      find_spread(radius / distance, spread);
      each_turn(row, bearing - spread, bearing + spread, [&](std::size_t first, std::size_t last) {
        in_vectors<project_body>(row, polygon.data(), polygon.size(), seen, first, last);
      });
    } else {
      in_vectors<project_body>(row, polygon.data(), polygon.size(), seen, 0, row.last);
    }
  }
}

void RangerSense::scan_walls(const Space& space, const Pose& X_WS, Rotation rotation, double z,
                             const View& view, const Scan& scan, Scratch& scratch) {
  if (space.walls.clear_about(X_WS.xy()) > scan.range_max) return;
  const geom::Box box = box_about(X_WS.xy(), scan.range_max + kMargin);
  const Row row(scan, X_WS.xy(), scratch.beam_x.data(), scratch.beam_y.data(),
                scratch.range.data() + scratch.first_beam, scratch.solid.data() + scratch.first_beam);
  const auto hides = [&](std::uint32_t solid) { return view.sees(space.solids, solid, z); };
  const auto project_wall = [&](const Walls::Edge& edge) {
    project_edge(edge.a - row.p, edge.b - row.p, rotation, number_of(edge.solid), row);
  };
  if (!space.walls.few().empty()) {
    for (const Walls::Edge& edge : space.walls.few())
      if (edge.reaches(box) && hides(edge.solid)) project_wall(edge);
    return;
  }
  if (space.walls.count_near(box) <= scan.count) {
    ++scratch.scans;
    space.walls.near(box, [&](const Walls::Edge& edge) {
      if (scratch.stamp[edge.number] == scratch.scans) return;
      scratch.stamp[edge.number] = scratch.scans;
      if (hides(edge.solid)) project_wall(edge);
    });
    return;
  }
  // With this many edges, tracing the beams is cheaper.
  Rays rays;
  const Rays::Part part{row.p, 0, 0, scan.range_max, view.root, view.is_wall, true};
  const bool marches = can_march(space.walls, part);
  for (std::size_t first = 0; first < scan.count; first += Rays::kMost) {
    put_beams(row, scan.range_max, z, first, part, rays);
    if (marches)
      march(space.walls, bit(Observer::kRanger), rays);
    else
      meet_walls_alone(space, rays.parts[0], rays);
    std::copy_n(rays.range, rays.count, row.range + first);
    std::copy_n(rays.solid, rays.count, row.solid + first);
  }
}

void RangerSense::run_scan(const Space& space, const View& view, const Scan& scan, Scratch& scratch) {
  std::fill_n(scratch.range.begin() + scratch.first_beam + scan.first_beam, scan.count, scan.range_max);
  const Pose X_WS = geom::compose(view.X_WM, scan.X_MS);
  const double z = view.X_WM.z + scan.z;
  const Rotation rotation = Rotation::of(X_WS.a);
  in_vectors<turn_beams>(rotation, scan.x.size(), scan.x.data(), scan.y.data(), scratch.beam_x.data(),
                         scratch.beam_y.data());
  scan_walls(space, X_WS, rotation, z, view, scan, scratch);
  scan_bodies(space, X_WS, rotation, z, view, scan, scratch);
}

}  // namespace playhouse::stage
