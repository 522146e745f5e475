/// Scans: instead of following each beam, what is near a scanner is projected onto the beams it covers, and
/// the nearest stays (a depth buffer of one row). Which beams a body may cover comes from a rough bearing,
/// widened; whether a beam meets it, and where, is exact. Bodies come from near to far, so that most hidden
/// ones are dropped at a glance.

#include <algorithm>
#include <bit>
#include <cmath>

#include "playhouse/stage/bearing.h"
#include "playhouse/stage/march.h"
#include "playhouse/stage/polygon_hit.h"
#include "playhouse/stage/sense_ranger.h"
#include "playhouse/stage/vectors.h"

namespace playhouse::stage {
namespace {

// Beams are handled four at a time; the columns of a row are that much longer than it.
static_assert(Scan::kSpare >= kFour);

/// The beams of a scan and what they have met so far.
struct Row {
  Vec2 p;               // where they begin, in W
  const double *x, *y;  // unit vectors in W
  double *range, *solid;
  std::size_t last;  // beam
  double half;       // of the fov  [rad]
  double per_step;   // beams per radian

  Row(const Scan& scan, Vec2 p_WS, const double* x_W, const double* y_W, double* ranges, double* solids)
      : p(p_WS),
        x(x_W),
        y(y_W),
        range(ranges + scan.first_beam),
        solid(solids + scan.first_beam),
        last(scan.count - 1),
        half(0.5 * scan.fov),
        per_step(1.0 / scan.step) {}

  /// The beam at or to the right of a bearing; 0 or the last one for those outside the fov.
  std::size_t beam_right_of(double bearing) const {
    const double beam = (bearing + half) * per_step;
    return beam <= 0 ? 0 : std::min(static_cast<std::size_t>(beam), last);
  }
  std::size_t beam_left_of(double bearing) const { return std::min(beam_right_of(bearing) + 1, last); }
};

/// Turns beams into W; what is behind the last one is no number and stays so.
PLAYHOUSE_INLINE void turn_beams(Rotation r, std::size_t count, const double* __restrict x_S,
                                 const double* __restrict y_S, double* __restrict x, double* __restrict y) {
  for (std::size_t k = 0; k < count; ++k) {
    x[k] = r.c * x_S[k] - r.s * y_S[k];
    y[k] = r.s * x_S[k] + r.c * y_S[k];
  }
}

/// Keeps the first of what is known and the edge from w0 to w1, which is to the right of w0 and which no beam
/// sees edge-on, for the beams from `first` on up to `last`, and a few more.
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

/// All beams and an edge with which the scanner is in line.
void project_in_line(const Row& row, Vec2 w0, Vec2 w1, double seen) {
  for (std::size_t k = 0; k <= row.last; ++k)
    keep_first(edge_hit(w0, w1, {row.x[k], row.y[k]}), seen, row.range[k], row.solid[k]);
}

/// Calls visit(first, last) for beams that hold all between two bearings, once for each turn by which those
/// can meet the beams'.
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

/// A body of any shape from anywhere, edge by edge.
void project_edges(std::span<const Vec2> polygon, Rotation rotation, double seen, const Row& row) {
  Vec2 before = polygon.back() - row.p;
  for (const Vec2 corner : polygon) {
    const Vec2 w = corner - row.p;
    project_edge(before, w, rotation, seen, row);
    before = w;
  }
}

/// A convex body from anywhere, beam by beam.
PLAYHOUSE_INLINE void project_body(const Row& row, const Vec2* polygon, std::size_t corners, double seen,
                                   std::size_t first, std::size_t last) {
  for (std::size_t k = first; k <= last; ++k)
    keep_first_alone(body_hit_here(polygon, corners, true, row.p, {row.x[k], row.y[k]}), seen, row.range[k],
                     row.solid[k]);
}

/// A convex body from outside, at a distance of up to `farthest`, all within the beams first .. last:
/// projects the edges that face the scanner, unless every beam has met something nearer than `nearest`.
PLAYHOUSE_INLINE void project_facing(const Row& row, const Vec2* __restrict polygon, std::size_t corners,
                                     double seen, double nearest, double farthest, std::size_t first,
                                     std::size_t last) {
  bool hidden = true;
  for (std::size_t k = first; k <= last && hidden; ++k) hidden = row.range[k] <= nearest;
  if (hidden) return;

  // Corners from where the scanner is and the areas of the edges from there, all of them twice.
  double u[2 * kConvexCorners], v[2 * kConvexCorners], area[2 * kConvexCorners];
  const Four number = Corners::kNumber;
  const double in_line = kEdgeOn * farthest;
  Four least = Four{} + kMiss;
  FourTruths facing = {}, edge = {1, 4, 2, 8};  // those that go clockwise about the scanner: bits of edges
  for (std::size_t i = 0; i < corners; i += kFour, edge <<= kFour) {
    const Corners w0(polygon + i, row.p), w1(polygon + i + 1, row.p);
    Four all;
    cross(w0.u, w0.v, w1.u, w1.v, all);
    all = number < static_cast<double>(corners - i) ? all : kMiss;
    facing |= (all < 0) & edge;
    const Four squared = all * all;
    least = least < squared ? least : squared;
    Corners::store_in_order(w0.u, u + i);
    Corners::store_in_order(w0.v, v + i);
    Corners::store_in_order(all, area + i);
  }
  const auto faces = static_cast<std::uint32_t>((facing[0] | facing[1]) | (facing[2] | facing[3]));
  // They follow each other, from one corner on.
  const std::uint32_t begins = faces & ~(faces << 1 | faces >> (corners - 1));
  if (!std::has_single_bit(begins) ||
      std::min(std::min(least[0], least[1]), std::min(least[2], least[3])) <= in_line * in_line) {
    project_body(row, polygon, corners, seen, first, last);
    return;
  }
  for (std::size_t i = 0; i < corners; i += kFour) {
    Four us, vs, areas;
    load(us, u + i);
    load(vs, v + i);
    load(areas, area + i);
    store(u + corners + i, us);
    store(v + corners + i, vs);
    store(area + corners + i, areas);
  }
  const auto begin = static_cast<std::size_t>(std::countr_zero(begins)),
             end = begin + static_cast<std::size_t>(std::popcount(faces));
  // A beam enters a convex body by one edge: one division serves all.
  const Four none = {0, 0, 0, 0};
  for (std::size_t k = first; k <= last; k += kFour) {
    Four x, y, range, solid, areas = none, slopes = none;
    load(x, row.x + k);
    load(y, row.y + k);
    load(range, row.range + k);
    load(solid, row.solid + k);
    Side<Four> w0(x, y, u[begin], v[begin]);
    for (std::size_t i = begin; i < end; ++i) {
      const Side<Four> w1(x, y, u[i + 1], v[i + 1]);
      const Crossing<Four> ends(w0, w1);
      areas += ends.enters ? area[i] : none;
      slopes += ends.enters ? ends.slope : none;
      w0 = w1;
    }
    keep_first<Four>(areas / slopes, Four{seen, seen, seen, seen}, range, solid);
    store(row.range + k, range);
    store(row.solid + k, solid);
  }
}

/// Replaces the rays by beams from the first on.
void put_beams(const Row& row, double range_max, double z, std::size_t first, Rays& rays) {
  rays.count = std::min(row.last + 1 - first, Rays::kMost);
  rays.parts[0] = {row.p, 0, rays.count};
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

/// Where discs matter: within `reach` of p, at this height, and along `ahead` no further back than `behind`.
struct Sector {
  Vec2 p;
  double reach, z;
  Vec2 ahead{0, 0};
  double behind = 0;
};

/// Centres from a sector's p along W's axes, and their places in the index.
struct Gathered {
  double *x, *y;  // m
  std::uint32_t* place;
};

/// Finds what is in a sector, among what is in the runs; returns how many. Behind the last there is room for
/// one more.
PLAYHOUSE_INLINE std::size_t gather(const Sector& sector, double radius_max, const DiscIndex::Places& places,
                                    const std::vector<DiscIndex::Run>& runs, const Gathered& out) {
  const double *const from_x = places.x.data(), *const from_y = places.y.data();
  const double *const z_min = places.z_min.data(), *const z_max = places.z_max.data();
  const Sector s = sector;
  const double far = (s.reach + radius_max) * (s.reach + radius_max) + kMargin;
  const Four number = {0, 1, 2, 3};
  std::size_t count = 0;
  for (const DiscIndex::Run& run : runs) {
    for (std::uint32_t i = run.begin; i < run.end; i += kFour) {
      Four x, y, low, high;
      load(x, from_x + i);
      load(y, from_y + i);
      load(low, z_min + i);
      load(high, z_max + i);
      x -= s.p.x;
      y -= s.p.y;
      const FourTruths is_in = (low <= s.z) & (high >= s.z) & (x * x + y * y <= far) &
                               (x * s.ahead.x + y * s.ahead.y >= s.behind) &
                               (number < static_cast<double>(run.end - i));
      for (std::uint32_t lane = 0; lane < kFour; ++lane) {  // what is not in it is overwritten
        out.x[count] = x[lane];
        out.y[count] = y[lane];
        out.place[count] = i + lane;
        count -= static_cast<std::size_t>(is_in[lane]);
      }
    }
  }
  return count;
}

/// Turns centres into the scanner's frame and measures their distances and rough bearings.
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

/// Half the angle under which something is seen, by the ratio of its radius and its distance: not below
/// asin(ratio), and kBearingError more.  [rad]
template <typename Number>
PLAYHOUSE_INLINE void find_spread(const Number& ratio, Number& spread) {
  spread = ratio + 0.5708 * ratio * ratio * ratio + kBearingError;
}

/// Finds the beams that may meet each body, by its radius, distance and bearing: `last` is -1 where that is
/// not easy to say, and the distance becomes kMiss where there are none. Four at a time, and up to three
/// more.
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

/// Puts the places of what may be seen into `order`, from near to far by rings; returns how many.
std::size_t RangerSense::Scratch::sort_by_distance(std::size_t count, double reach) {
  constexpr std::size_t kRings = 32;
  std::uint32_t first[kRings + 2] = {};
  const double per_ring = static_cast<double>(kRings) / reach;
  const double* const far = distance.data();
  std::int32_t* const ring = this->ring.data();
  for (std::size_t i = 0; i < count; ++i)
    ring[i] = static_cast<std::int32_t>(far[i] < reach ? far[i] * per_ring : static_cast<double>(kRings));
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
  const double radius_max = space.index.radius_max() + kMargin;
  Sector sector{X_WS.xy(), scan.range_max + kMargin, z, {0, 0}, 0};
  if (scan.fov <= geom::kPi) {  // no beam points back, so none meets what is all behind
    sector.ahead = {rotation.c, rotation.s};
    sector.behind = -radius_max;
  }
  space.index.find_runs(sector.p, sector.reach, z, z, scratch.runs);
  const std::size_t near =
      in_vectors<gather>(sector, space.index.radius_max(), space.index.places(), scratch.runs,
                         Gathered{scratch.x.data(), scratch.y.data(), scratch.place.data()});
  const DiscIndex::Disc* const discs = space.index.discs();
  for (std::size_t i = 0; i < near; ++i) scratch.radius[i] = discs[scratch.place[i]].radius + kMargin;
  in_vectors<find_distances>(rotation, near, scratch.x.data(), scratch.y.data(), scratch.distance.data(),
                             scratch.bearing.data());
  in_vectors<find_beams>(row, near, scratch.radius.data(), scratch.bearing.data(), scratch.distance.data(),
                         scratch.first.data(), scratch.last.data());
  const std::size_t count = scratch.sort_by_distance(near, scan.range_max + radius_max);

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
  // So many edges: following the beams is cheaper.
  Rays rays;
  const bool marches = can_march(space.walls, view, scan.range_max);
  for (std::size_t first = 0; first < scan.count; first += Rays::kMost) {
    put_beams(row, scan.range_max, z, first, rays);
    if (marches)
      march(space.walls, bit(Observer::kRanger), rays);
    else
      meet_walls_alone(space, view, rays.parts[0], rays);
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
