/// Scans: instead of following each beam, every edge near a scanner is projected onto the beams it covers,
/// and the nearest stays (a depth buffer of one row). Which beams an edge may cover comes from a rough
/// bearing, widened; whether a beam meets it, and where, is exact.

#include <algorithm>
#include <cmath>

#include "playhouse/stage/sense_ranger.h"

namespace playhouse::stage {
namespace {

constexpr double kBearingError = 1e-4;  // rad; rough_bearing() is better than this, see scan_test.cc

/// atan2 to 1e-4, in (-pi, pi].
double rough_bearing(Vec2 v) {
  const double ax = std::fabs(v.x), ay = std::fabs(v.y);
  const double large = ax > ay ? ax : ay, small = ax > ay ? ay : ax;
  const double t = large > 0 ? small / large : 0, s = t * t;
  double angle =
      t * (0.99997726 +
           s * (-0.33262347 + s * (0.19354346 + s * (-0.11643287 + s * (0.05265332 - s * 0.01172120)))));
  angle = ay > ax ? 0.5 * geom::kPi - angle : angle;
  angle = v.x < 0 ? geom::kPi - angle : angle;
  return v.y < 0 ? -angle : angle;
}

/// An edge as the scanner sees it, w0 to the right of w1.
struct Sight {
  Vec2 w0, w1;      // m, in S
  double area;      // cross(w0, w1), above 0
  double from, to;  // rough bearings; to - from in (0, pi) when below and above are honest
  double intensity;
};

/// Keeps the nearer of what is known and the edge, beams first .. last.
void project(const Sight& sight, const double* __restrict x, const double* __restrict y,
             double* __restrict range, double* __restrict intensity, std::size_t first, std::size_t last) {
  for (std::size_t k = first; k <= last; ++k) {
    const double s0 = x[k] * sight.w0.y - y[k] * sight.w0.x;
    const double s1 = x[k] * sight.w1.y - y[k] * sight.w1.x;
    const double t = sight.area / (s1 - s0);
    const bool nearer = (s0 <= 0) & (s1 >= 0) & (t < range[k]);
    range[k] = nearer ? t : range[k];
    intensity[k] = nearer ? sight.intensity : intensity[k];
  }
}

/// The beams that `sight` may cover, once for each turn by which its bearings can meet those of the beams.
void project_turns(const Sight& sight, const Scan& scan, double* range, double* intensity) {
  const double half = 0.5 * scan.fov;
  const double to = sight.to < sight.from - 3.0 ? sight.to + geom::kTwoPi : sight.to;
  const auto turns = static_cast<int>(half / geom::kTwoPi) + 1;
  for (int turn = -turns; turn <= turns; ++turn) {
    const double low = sight.from + turn * geom::kTwoPi - kBearingError;
    const double high = to + turn * geom::kTwoPi + kBearingError;
    if (high < -half || low > half) continue;
    const double beams = static_cast<double>(scan.beams() - 1);
    const double first = std::clamp(std::floor((low + half) / scan.step), 0.0, beams);
    const double last = std::clamp(std::ceil((high + half) / scan.step), 0.0, beams);
    project(sight, scan.x.data(), scan.y.data(), range, intensity, static_cast<std::size_t>(first),
            static_cast<std::size_t>(last));
  }
}

}  // namespace

void RangerSense::scan_walls(const Space& space, const View& view, const Scan& scan, Bench& bench) {
  const Pose X_WS = geom::compose(view.X_WM, scan.X_MS);
  const double z = view.X_WM.z + scan.z;
  const geom::Box box = box_about(X_WS.xy(), scan.range_max);
  const std::size_t listings = space.walls.count_near(box);
  if (listings == 0) return;
  double* const range = bench.range.data() + scan.first_beam;
  double* const intensity = bench.intensity.data() + scan.first_beam;
  const auto hides = [&](std::uint32_t row) {
    return view.sees(space.solids, row) && at_height(space.solids, row, z);
  };
  const Rotation rotation = Rotation::of(X_WS.a);

  if (listings > 4 * scan.beams()) {  // so many edges: following the beams is cheaper
    for (std::size_t k = 0; k < scan.beams(); ++k) {
      const Vec2 d = rotation * Vec2{scan.x[k], scan.y[k]};
      space.walls.along(X_WS.xy(), d, &range[k], [&](const Walls::Edge& edge) {
        const double t = edge_hit(edge.a - X_WS.xy(), edge.b - X_WS.xy(), d);
        if (t >= range[k] || !hides(edge.solid)) return;
        range[k] = t;
        intensity[k] = space.solids.ranger_return[edge.solid];
      });
    }
    return;
  }

  ++bench.scans;
  space.walls.near(box, [&](const Walls::Edge& edge) {
    if (bench.stamp[edge.number] == bench.scans) return;
    bench.stamp[edge.number] = bench.scans;
    if (!hides(edge.solid)) return;
    Vec2 w0 = rotation.inverse(edge.a - X_WS.xy()), w1 = rotation.inverse(edge.b - X_WS.xy());
    if (geom::cross(w0, w1) < 0) std::swap(w0, w1);
    const double area = geom::cross(w0, w1);
    if (area <= 0) return;
    project_turns(
        {w0, w1, area, rough_bearing(w0), rough_bearing(w1), space.solids.ranger_return[edge.solid]}, scan,
        range, intensity);
  });
}

void RangerSense::run_scan(const Space& space, const View& view, const Scan& scan, Bench& bench) {
  const Solids& solids = space.solids;
  double* const range = bench.range.data() + scan.first_beam;
  double* const intensity = bench.intensity.data() + scan.first_beam;
  std::fill_n(range, scan.beams(), scan.range_max);
  scan_walls(space, view, scan, bench);

  const Pose X_WS = geom::compose(view.X_WM, scan.X_MS);
  const Rotation rotation = Rotation::of(X_WS.a);
  const double z = view.X_WM.z + scan.z;
  space.index.near(X_WS.xy(), scan.range_max, [&](const DiscIndex::Disc& disc) {
    const Vec2 to_disc = disc.center - X_WS.xy();
    const double reach = scan.range_max + disc.radius, squared = geom::dot(to_disc, to_disc);
    if (squared > reach * reach || z < disc.z_min || disc.z_max < z || !view.sees(solids, disc.row)) return;

    const std::span<const Vec2> polygon = solids.polygon(disc.row);
    const std::size_t corners = polygon.size();
    for (std::size_t i = 0; i < corners; ++i) {
      bench.corner[i] = rotation.inverse(polygon[i] - X_WS.xy());
      bench.bearing[i] = rough_bearing(bench.corner[i]);
    }
    bench.corner[corners] = bench.corner[0];
    bench.bearing[corners] = bench.bearing[0];
    // From outside, the nearest edge along any beam faces the scanner: it goes clockwise about it.
    const double outside = disc.radius + kMargin;
    const bool inside_possible = squared < outside * outside;
    for (std::size_t i = 0; i < corners; ++i) {
      const double area = geom::cross(bench.corner[i], bench.corner[i + 1]);
      if (area < 0)
        project_turns({bench.corner[i + 1], bench.corner[i], -area, bench.bearing[i + 1], bench.bearing[i],
                       solids.ranger_return[disc.row]},
                      scan, range, intensity);
      else if (inside_possible && area > 0)
        project_turns({bench.corner[i], bench.corner[i + 1], area, bench.bearing[i], bench.bearing[i + 1],
                       solids.ranger_return[disc.row]},
                      scan, range, intensity);
    }
  });
}

}  // namespace playhouse::stage
