/// Scans: instead of following each beam, what is near a scanner is projected onto the beams it covers, and
/// the nearest stays (a depth buffer of one row). Which beams a body may cover comes from a rough bearing,
/// widened; whether a beam meets it, and where, is exact. Bodies come from near to far, so that most hidden
/// ones are dropped at a glance.

#include <algorithm>
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
  const double *x, *y;  // unit vectors in S
  double *range, *intensity;
  std::size_t last;  // beam
  double half;       // of the fov  [rad]
  double per_step;   // beams per radian

  Row(const Scan& scan, double* ranges, double* intensities)
      : x(scan.x.data()),
        y(scan.y.data()),
        range(ranges + scan.first_beam),
        intensity(intensities + scan.first_beam),
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

/// Keeps the nearer of what is known and the edge from w0 to w1, which is to the left of w0, for the beams
/// from `first` on up to `last`, and a few more.
PLAYHOUSE_INLINE void project(const Row& row, Vec2 w0, Vec2 w1, double seen, std::size_t first,
                              std::size_t last) {
  const double area = w0.x * w1.y - w0.y * w1.x;
  for (std::size_t k = first; k <= last; k += kFour) {
    Four x, y, range, intensity;
    load(x, row.x + k);
    load(y, row.y + k);
    load(range, row.range + k);
    load(intensity, row.intensity + k);
    const Four s0 = x * w0.y - y * w0.x, s1 = x * w1.y - y * w1.x;
    const Four t = area / (s1 - s0);
    const auto nearer = (s0 <= 0) & (s1 >= 0) & (t < range);
    range = nearer ? t : range;
    intensity = nearer ? seen : intensity;
    store(row.range + k, range);
    store(row.intensity + k, intensity);
  }
}

/// Projects an edge, once for each turn by which its bearings can meet those of the beams.
void project_edge(Vec2 w0, Vec2 w1, double intensity, const Row& row) {
  const double area = geom::cross(w0, w1);
  if (area == 0) return;
  if (area < 0) std::swap(w0, w1);
  const double from = rough_bearing(w0) - kBearingError;
  double to = rough_bearing(w1) + kBearingError;
  if (to < from - 3.0) to += geom::kTwoPi;
  const auto turns = static_cast<int>(row.half / geom::kTwoPi) + 1;
  for (int turn = -turns; turn <= turns; ++turn) {
    const double low = from + turn * geom::kTwoPi, high = to + turn * geom::kTwoPi;
    if (high < -row.half || low > row.half) continue;
    in_vectors<project>(row, w0, w1, intensity, row.beam_right_of(low), row.beam_left_of(high));
  }
}

/// A body of any shape from anywhere, edge by edge.
void project_edges(std::span<const Vec2> polygon, const Pose& X_WS, Rotation rotation, double seen,
                   const Row& row) {
  Vec2 before = rotation.inverse(polygon.back() - X_WS.xy());
  for (const Vec2 corner : polygon) {
    const Vec2 w = rotation.inverse(corner - X_WS.xy());
    project_edge(before, w, seen, row);
    before = w;
  }
}

constexpr std::size_t kFacingCorners = 32;

/// A convex body of up to kFacingCorners from outside, all within the beams first .. last: projects the edges
/// that face the scanner, unless every beam has met something nearer than `nearest`.
PLAYHOUSE_INLINE void project_facing(const Row& row, const Vec2* __restrict polygon, std::size_t corners,
                                     Vec2 origin, Rotation r, double seen, double nearest, std::size_t first,
                                     std::size_t last) {
  bool hidden = true;
  for (std::size_t k = first; k <= last && hidden; ++k) hidden = row.range[k] <= nearest;
  if (hidden) return;

  double u0[kFacingCorners], v0[kFacingCorners], u1[kFacingCorners], v1[kFacingCorners], area[kFacingCorners];
  const Four number = Corners::kNumber, none = {0, 0, 0, 0};
  std::size_t sides = 0;
  for (std::size_t i = 0; i < corners; i += kFour, sides += kFour) {
    const Corners w0(polygon + i, origin), w1(polygon + i + 1, origin);
    const Four a0 = r.c * w0.u + r.s * w0.v, b0 = r.c * w0.v - r.s * w0.u;
    const Four a1 = r.c * w1.u + r.s * w1.v, b1 = r.c * w1.v - r.s * w1.u;
    store(u0 + i, a0);
    store(v0 + i, b0);
    store(u1 + i, a1);
    store(v1 + i, b1);
    store<Four>(area + i, number < static_cast<double>(corners - i) ? a1 * b0 - a0 * b1 : none);
  }
  std::size_t facing[kFacingCorners], count = 0;  // edges that go clockwise about the scanner
  for (std::size_t i = 0; i < sides; ++i) {
    facing[count] = i;
    count += area[i] > 0;
  }
  // A beam enters a convex body by one edge: one division serves all.
  for (std::size_t k = first; k <= last; k += kFour) {
    Four x, y, range, intensity, met_area = none, slope = none;
    load(x, row.x + k);
    load(y, row.y + k);
    load(range, row.range + k);
    load(intensity, row.intensity + k);
    for (std::size_t n = 0; n < count; ++n) {
      const std::size_t i = facing[n];
      const Four s0 = x * v1[i] - y * u1[i], s1 = x * v0[i] - y * u0[i];
      const auto enters = (s0 <= 0) & (s1 >= 0);
      met_area = enters ? area[i] : met_area;
      slope = enters ? s1 - s0 : slope;
    }
    const Four t = met_area / slope;
    const auto nearer = t < range;
    range = nearer ? t : range;
    intensity = nearer ? seen : intensity;
    store(row.range + k, range);
    store(row.intensity + k, intensity);
  }
}

/// Replaces the rays by beams from the first on.
void put_beams(const Scan& scan, Vec2 p_WS, Rotation rotation, double z, std::size_t first, Rays& rays) {
  rays.count = std::min(scan.count - first, Rays::kMost);
  rays.parts[0] = {p_WS, 0, rays.count};
  rays.part_count = 1;
  for (std::size_t k = 0; k < rays.count; ++k) {
    const Vec2 d = rotation * Vec2{scan.x[first + k], scan.y[first + k]};
    rays.px[k] = p_WS.x;
    rays.py[k] = p_WS.y;
    rays.dx[k] = d.x;
    rays.dy[k] = d.y;
    rays.z[k] = z;
    rays.range[k] = scan.range_max;
    rays.intensity[k] = 0;
  }
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
  const Row row(scan, scratch.range.data() + scratch.first_beam,
                scratch.intensity.data() + scratch.first_beam);
  const double radius_max = space.index.radius_max() + kMargin;
  Sector sector{X_WS.xy(), scan.range_max, z, z, {0, 0}, 0};
  if (scan.fov <= geom::kPi) {  // no beam points back, so none meets what is all behind
    sector.ahead = {rotation.c, rotation.s};
    sector.behind = -radius_max;
  }
  const std::size_t near = scratch.gather(space.index, sector);
  in_vectors<find_distances>(rotation, near, scratch.x.data(), scratch.y.data(), scratch.distance.data(),
                             scratch.bearing.data());
  const std::size_t count = scratch.sort_by_distance(near, scan.range_max + radius_max);

  constexpr std::size_t kAhead = 3;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t at = scratch.order[i];
    const DiscIndex::Disc& disc = space.index.discs()[scratch.place[at]];
    if (i + kAhead < count) {
      const Vec2* const soon =
          solids.p.data() + space.index.discs()[scratch.place[scratch.order[i + kAhead]]].first_vertex;
      __builtin_prefetch(soon);
      __builtin_prefetch(soon + 4);
      __builtin_prefetch(soon + 8);
    }
    if (!view.sees(disc)) continue;
    const double distance = scratch.distance[at], radius = disc.radius + kMargin;
    const double x = radius / distance;
    const double spread = x + 0.5708 * x * x * x + kBearingError;  // not below asin(x)
    const double from = scratch.bearing[at] - spread, to = scratch.bearing[at] + spread;
    const std::span<const Vec2> polygon(solids.p.data() + disc.first_vertex, disc.vertices);
    const bool in_front = (x < 1) & (row.half <= geom::kPi) & (from > -geom::kPi) & (to < geom::kPi);
    if (!in_front || !disc.convex || polygon.size() > kFacingCorners) {
      project_edges(polygon, X_WS, rotation, disc.ranger_return, row);
    } else if (to >= -row.half && from <= row.half) {
      in_vectors<project_facing>(row, polygon.data(), polygon.size(), X_WS.xy(), rotation, disc.ranger_return,
                                 distance - radius, row.beam_right_of(from), row.beam_left_of(to));
    }
  }
}

void RangerSense::scan_walls(const Space& space, const Pose& X_WS, Rotation rotation, double z,
                             const View& view, const Scan& scan, Scratch& scratch) {
  if (space.walls.clear_about(X_WS.xy()) > scan.range_max) return;
  const geom::Box box = box_about(X_WS.xy(), scan.range_max);
  const Row row(scan, scratch.range.data() + scratch.first_beam,
                scratch.intensity.data() + scratch.first_beam);
  const auto hides = [&](std::uint32_t solid) { return view.sees(space.solids, solid, z); };
  const auto project_wall = [&](const Walls::Edge& edge) {
    project_edge(rotation.inverse(edge.a - X_WS.xy()), rotation.inverse(edge.b - X_WS.xy()),
                 space.solids.ranger_return[edge.solid], row);
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
    put_beams(scan, X_WS.xy(), rotation, z, first, rays);
    if (marches)
      march(space.walls, rays);
    else
      meet_walls_alone(space, view, rays.parts[0], rays);
    std::copy_n(rays.range, rays.count, row.range + first);
    std::copy_n(rays.intensity, rays.count, row.intensity + first);
  }
}

void RangerSense::run_scan(const Space& space, const View& view, const Scan& scan, Scratch& scratch) {
  std::fill_n(scratch.range.begin() + scratch.first_beam + scan.first_beam, scan.count, scan.range_max);
  const Pose X_WS = geom::compose(view.X_WM, scan.X_MS);
  const double z = view.X_WM.z + scan.z;
  const Rotation rotation = Rotation::of(X_WS.a);
  scan_walls(space, X_WS, rotation, z, view, scan, scratch);
  scan_bodies(space, X_WS, rotation, z, view, scan, scratch);
}

}  // namespace playhouse::stage
