/// Scans: instead of following each beam, what is near a scanner is projected onto the beams it covers, and
/// the nearest stays (a depth buffer of one row). Which beams a body may cover comes from a rough bearing,
/// widened; whether a beam meets it, and where, is exact. Bodies come from near to far, so that most hidden
/// ones are dropped at a glance.

#include <algorithm>
#include <bit>
#include <cmath>

#include "playhouse/stage/bearing.h"
#include "playhouse/stage/sense_ranger.h"
#include "playhouse/stage/vectors.h"

namespace playhouse::stage {
namespace {

/// The beams of a scan and what they have met so far.
struct Row {
  const Scan& scan;
  double half;      // of the fov  [rad]
  double per_step;  // beams per radian
  double* range;
  double* intensity;

  std::size_t last;  // beam

  std::size_t beams() const { return last + 1; }
  /// The beam at or to the right of a bearing; 0 or the last one for those outside the fov.
  std::size_t beam_right_of(double bearing) const {
    const double beam = (bearing + half) * per_step;
    return beam <= 0 ? 0 : std::min(static_cast<std::size_t>(beam), last);
  }
  /// cross(beam k, w): above 0 if w is to the left of the beam.
  double side(std::size_t k, Vec2 w) const { return scan.x[k] * w.y - scan.y[k] * w.x; }
};

/// An edge as the scanner sees it, w0 to the right of w1.
struct Sight {
  Vec2 w0, w1;  // m, in S
  double area;  // cross(w0, w1), above 0
  double intensity;
};

/// Keeps the nearer of what is known and the edge, beams first .. last.
PLAYHOUSE_VECTORS void project(const Sight& sight, const double* __restrict x, const double* __restrict y,
                               double* __restrict range, double* __restrict intensity, std::size_t first,
                               std::size_t last) {
  for (std::size_t k = first; k <= last; ++k) {
    const double s0 = x[k] * sight.w0.y - y[k] * sight.w0.x;
    const double s1 = x[k] * sight.w1.y - y[k] * sight.w1.x;
    const double t = sight.area / (s1 - s0);
    const bool nearer = (s0 <= 0) & (s1 >= 0) & (t < range[k]);
    range[k] = nearer ? t : range[k];
    intensity[k] = nearer ? sight.intensity : intensity[k];
  }
}

/// Projects an edge, once for each turn by which its bearings can meet those of the beams.
void project_edge(Vec2 w0, Vec2 w1, double intensity, const Row& row) {
  double area = geom::cross(w0, w1);
  if (area == 0) return;
  if (area < 0) {
    std::swap(w0, w1);
    area = -area;
  }
  const double from = rough_bearing(w0) - kBearingError;
  double to = rough_bearing(w1) + kBearingError;
  if (to < from - 3.0) to += geom::kTwoPi;
  const auto turns = static_cast<int>(row.half / geom::kTwoPi) + 1;
  for (int turn = -turns; turn <= turns; ++turn) {
    const double low = from + turn * geom::kTwoPi, high = to + turn * geom::kTwoPi;
    if (high < -row.half || low > row.half) continue;
    const std::size_t last = std::min(row.beam_right_of(high) + 1, row.last);
    project({w0, w1, area, intensity}, row.scan.x.data(), row.scan.y.data(), row.range, row.intensity,
            row.beam_right_of(low), last);
  }
}

/// The corners of one polygon as the scanner sees it, the first again at the end.
struct Corners {
  const double *x, *y;
  std::size_t count;
  Vec2 operator[](std::size_t i) const { return {x[i], y[i]}; }
};

/// A body of any shape from anywhere, edge by edge.
void project_edges(const Corners& corners, double intensity, const Row& row) {
  for (std::size_t i = 0; i < corners.count; ++i) project_edge(corners[i], corners[i + 1], intensity, row);
}

/// The edges of a convex polygon that face the origin, which is outside: they follow each other.
struct Facing {
  std::size_t left = 0, edges = 0;  // corner `left` is the left end; 0 edges: none is sure to face
};

constexpr std::size_t kFacingCorners = 32;

PLAYHOUSE_VECTORS Facing find_facing(const Corners& corners) {
  double area[kFacingCorners];
  const double *x = corners.x, *y = corners.y;
  for (std::size_t i = 0; i < corners.count; ++i) area[i] = x[i] * y[i + 1] - x[i + 1] * y[i];
  std::uint64_t faces = 0;
  for (std::size_t i = 0; i < corners.count; ++i) faces |= std::uint64_t{area[i] < 0} << i;
  const std::uint64_t before = (faces << 1) | (faces >> (corners.count - 1));  // bit i: edge i - 1 faces
  const std::uint64_t starts = faces & ~before;
  if (!std::has_single_bit(starts)) return {};
  return {static_cast<std::size_t>(std::countr_zero(starts)), static_cast<std::size_t>(std::popcount(faces))};
}

/// A convex body from outside: its facing edges follow each other from right to left, and so do the beams
/// that meet them. `k` is a beam to the right of them all; no edge crosses the line behind the scanner.
void project_facing(const Corners& corners, const Facing& facing, double intensity, std::size_t k,
                    const Row& row) {
  std::size_t right = facing.left + facing.edges;
  right = right < corners.count ? right : right - corners.count;
  Vec2 w0 = corners[right];
  const double *const x = row.scan.x.data(), *const y = row.scan.y.data();
  double *const range = row.range, *const seen = row.intensity;
  const std::size_t beams = row.beams();
  while (k < beams && x[k] * w0.y - y[k] * w0.x > 0) ++k;
  for (std::size_t edge = facing.edges; edge > 0 && k < beams; --edge) {
    right = right > 0 ? right - 1 : corners.count - 1;
    const Vec2 w1 = corners[right];
    const double area = geom::cross(w0, w1);
    for (; k < beams; ++k) {
      const double s1 = x[k] * w1.y - y[k] * w1.x;
      if (s1 < 0) break;
      const double t = area / (s1 - (x[k] * w0.y - y[k] * w0.x));
      const bool nearer = t < range[k];
      range[k] = nearer ? t : range[k];
      seen[k] = nearer ? intensity : seen[k];
    }
    w0 = w1;
  }
}

PLAYHOUSE_VECTORS void find_corners(const Vec2* __restrict p, std::size_t count, Vec2 origin, Rotation r,
                                    double* __restrict x, double* __restrict y) {
  for (std::size_t i = 0; i < count; ++i) {
    const double u = p[i].x - origin.x, v = p[i].y - origin.y;
    x[i] = r.c * u + r.s * v;
    y[i] = r.c * v - r.s * u;
  }
  x[count] = x[0];
  y[count] = y[0];
}

/// Turns centres into the scanner's frame and measures their distances and rough bearings.
PLAYHOUSE_VECTORS void find_distances(Rotation r, std::size_t count, double* __restrict x,
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

/// True if every beam from one bearing to another has met something nearer.
bool is_hidden(double from, double to, double nearest, const Row& row) {
  const std::size_t last = std::min(row.beam_right_of(to) + 1, row.last);
  for (std::size_t k = row.beam_right_of(from); k <= last; ++k)
    if (row.range[k] > nearest) return false;
  return true;
}

}  // namespace

/// Puts the places of what may be seen into `order`, from near to far by rings; returns how many.
std::size_t RangerSense::Bench::sort_by_distance(std::size_t count, double reach) {
  constexpr std::size_t kRings = 32;
  std::uint32_t first[kRings + 2] = {};
  const double per_ring = static_cast<double>(kRings) / reach;
  const double* const far = distance.data();
  std::int32_t* const ring = cell.data();
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

void RangerSense::scan_bodies(const Space& space, const Pose& X_WS, double z, const View& view,
                              const Scan& scan, Bench& bench) {
  const Solids& solids = space.solids;
  const Rotation rotation = Rotation::of(X_WS.a);
  const Row row{scan,
                0.5 * scan.fov,
                1.0 / scan.step,
                bench.range.data() + scan.first_beam,
                bench.intensity.data() + scan.first_beam,
                scan.beams() - 1};
  const double radius_max = space.index.radius_max() + kMargin;
  Sector sector{X_WS.xy(), scan.range_max, z, z, {0, 0}, 0};
  if (scan.fov <= geom::kPi) {  // no beam points back, so none meets what is all behind
    sector.ahead = {rotation.c, rotation.s};
    sector.behind = -radius_max;
  }
  const std::size_t near = bench.gather(space.index, sector);
  find_distances(rotation, near, bench.x.data(), bench.y.data(), bench.distance.data(), bench.bearing.data());
  const std::size_t count = bench.sort_by_distance(near, scan.range_max + radius_max);

  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t at = bench.order[i];
    const DiscIndex::Disc& disc = space.index.discs()[bench.place[at]];
    if (!view.sees(solids, disc.row)) continue;
    const double distance = bench.distance[at], radius = disc.radius + kMargin;
    const double x = radius / distance;
    const double spread = x + 0.5708 * x * x * x + kBearingError;  // not below asin(x)
    const double from = bench.bearing[at] - spread, to = bench.bearing[at] + spread;
    const bool in_front = x < 1 && row.half <= geom::kPi && from > -geom::kPi && to < geom::kPi;
    if (in_front && (to < -row.half || from > row.half || is_hidden(from, to, distance - radius, row)))
      continue;

    const std::span<const Vec2> polygon = solids.polygon(disc.row);
    find_corners(polygon.data(), polygon.size(), X_WS.xy(), rotation, bench.corner_x.data(),
                 bench.corner_y.data());
    const Corners corners{bench.corner_x.data(), bench.corner_y.data(), polygon.size()};
    const double intensity = solids.ranger_return[disc.row];
    if (in_front && solids.convex[disc.row] && polygon.size() <= kFacingCorners) {
      const Facing facing = find_facing(corners);
      if (facing.edges > 0) {
        project_facing(corners, facing, intensity, row.beam_right_of(from), row);
        continue;
      }
    }
    project_edges(corners, intensity, row);
  }
}

void RangerSense::scan_walls(const Space& space, const Pose& X_WS, double z, const View& view,
                             const Scan& scan, Bench& bench) {
  if (space.walls.edge_count() == 0) return;
  const geom::Box box = box_about(X_WS.xy(), scan.range_max);
  const Row row{scan,
                0.5 * scan.fov,
                1.0 / scan.step,
                bench.range.data() + scan.first_beam,
                bench.intensity.data() + scan.first_beam,
                scan.beams() - 1};
  const auto hides = [&](std::uint32_t solid) {
    return view.sees(space.solids, solid) && at_height(space.solids, solid, z);
  };
  const Rotation rotation = Rotation::of(X_WS.a);

  const auto project_wall = [&](const Walls::Edge& edge) {
    project_edge(rotation.inverse(edge.a - X_WS.xy()), rotation.inverse(edge.b - X_WS.xy()),
                 space.solids.ranger_return[edge.solid], row);
  };
  if (!space.walls.few().empty()) {
    for (const Walls::Edge& edge : space.walls.few())
      if (edge.reaches(box) && hides(edge.solid)) project_wall(edge);
    return;
  }
  if (space.walls.count_near(box) <= 2 * scan.beams()) {
    ++bench.scans;
    space.walls.near(box, [&](const Walls::Edge& edge) {
      if (bench.stamp[edge.number] == bench.scans) return;
      bench.stamp[edge.number] = bench.scans;
      if (hides(edge.solid)) project_wall(edge);
    });
    return;
  }
  for (std::size_t k = 0; k < scan.beams(); ++k) {  // so many edges: following the beams is cheaper
    const Vec2 d = rotation * Vec2{scan.x[k], scan.y[k]};
    space.walls.along(X_WS.xy(), d, &row.range[k], [&](const Walls::Edge& edge) {
      const double t = edge_hit(edge.a - X_WS.xy(), edge.b - X_WS.xy(), d);
      if (t >= row.range[k] || !hides(edge.solid)) return;
      row.range[k] = t;
      row.intensity[k] = space.solids.ranger_return[edge.solid];
    });
  }
}

void RangerSense::run_scan(const Space& space, const View& view, const Scan& scan, Bench& bench) {
  std::fill_n(bench.range.begin() + scan.first_beam, scan.beams(), scan.range_max);
  const Pose X_WS = geom::compose(view.X_WM, scan.X_MS);
  const double z = view.X_WM.z + scan.z;
  scan_walls(space, X_WS, z, view, scan, bench);
  scan_bodies(space, X_WS, z, view, scan, bench);
}

}  // namespace playhouse::stage
