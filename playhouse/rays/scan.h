#pragma once

/// Inner loops of scans (scan.cc): projection of nearby bodies onto a row of beams.
///
/// In: the beams of a scan, and bodies near it.
/// Out: range and solid of the beams.
/// Cost: for four beams at once an edge's crossing for each edge that faces the scanner, and a division;
///   bodies are gathered four at a time.

#include <algorithm>
#include <bit>
#include <vector>

#include "playhouse/bodies/disc_index.h"
#include "playhouse/bodies/polygon_hit.h"
#include "playhouse/rays/ranger_kinds.h"
#include "playhouse/simd/vectors.h"

namespace playhouse::rays {

// Vector loops handle up to eight beams; the columns of a row are padded by that much.
static_assert(Scan::kPad >= simd::kEight);

/// The beams of a scan and their nearest hits so far.
struct ScanBeams {
  geom::Vec2 p;         // origin in W
  const double *x, *y;  // unit vectors in W
  double *range, *solid;
  std::size_t last;  // beam
  double half;       // of the fov  [rad]
  double per_step;   // beams per radian

  ScanBeams(const Scan& scan, geom::Vec2 p_WS, const double* x_W, const double* y_W, double* ranges,
            double* solids)
      : p(p_WS),
        x(x_W),
        y(y_W),
        range(ranges + scan.first_beam),
        solid(solids + scan.first_beam),
        last(scan.count - 1),
        half(0.5 * scan.fov),
        per_step(1.0 / scan.step) {}

  /// The last beam at or to the right of a bearing, clamped to the first and last beam.
  std::size_t beam_right_of(double bearing) const {
    const double beam = (bearing + half) * per_step;
    return beam <= 0 ? 0 : std::min(static_cast<std::size_t>(beam), last);
  }
  std::size_t beam_left_of(double bearing) const { return std::min(beam_right_of(bearing) + 1, last); }
};

/// A convex body seen from anywhere: one intersection per beam.
PLAYHOUSE_INLINE void project_body(const ScanBeams& row, const geom::Vec2* polygon, std::size_t corners,
                                   double seen, std::size_t first, std::size_t last) {
  for (std::size_t k = first; k <= last; ++k)
    bodies::keep_first_alone(bodies::body_hit_here(polygon, corners, true, row.p, {row.x[k], row.y[k]}), seen,
                             row.range[k], row.solid[k]);
}

/// True if each of these beams has a hit at `nearest` or nearer: the body is occluded.
PLAYHOUSE_INLINE bool is_hidden(const ScanBeams& row, double nearest, std::size_t first, std::size_t last) {
  bool hidden = true;
  for (std::size_t k = first; k <= last && hidden; ++k) hidden = row.range[k] <= nearest;
  return hidden;
}

/// A convex body seen from outside, at up to `farthest` metres, within the beams
/// first .. last: projects its front-facing edges, unless closer hits occlude it.
PLAYHOUSE_INLINE void project_facing(const ScanBeams& row, const geom::Vec2* __restrict polygon,
                                     std::size_t corners, double seen, double nearest, double farthest,
                                     std::size_t first, std::size_t last) {
  if (is_hidden(row, nearest, first, last)) return;

  // Corners relative to the scanner and cross products of edges, each twice: runs need no wrap-around.
  double u[2 * bodies::kConvexCorners], v[2 * bodies::kConvexCorners], area[2 * bodies::kConvexCorners];
  const simd::Double4 number = bodies::Corners::kNumber;
  const double in_line = bodies::kEdgeOn * farthest;
  simd::Double4 least = simd::Double4{} + bodies::kMiss;
  simd::Mask4 facing = {}, edge = {1, 4, 2, 8};  // front-facing (clockwise about the scanner), a bit mask
  for (std::size_t i = 0; i < corners; i += simd::kFour, edge <<= simd::kFour) {
    const bodies::Corners w0(polygon + i, row.p), w1(polygon + i + 1, row.p);
    simd::Double4 all;
    bodies::cross(w0.u, w0.v, w1.u, w1.v, all);
    all = number < static_cast<double>(corners - i) ? all : bodies::kMiss;
    facing |= (all < 0) & edge;
    const simd::Double4 squared = all * all;
    least = least < squared ? least : squared;
    bodies::Corners::store_in_order(w0.u, u + i);
    bodies::Corners::store_in_order(w0.v, v + i);
    bodies::Corners::store_in_order(all, area + i);
  }
  const auto faces = static_cast<std::uint32_t>((facing[0] | facing[1]) | (facing[2] | facing[3]));
  // Front-facing edges are consecutive; more than one run means a degenerate view.
  const std::uint32_t begins = faces & ~(faces << 1 | faces >> (corners - 1));
  if (!std::has_single_bit(begins) ||
      std::min(std::min(least[0], least[1]), std::min(least[2], least[3])) <= in_line * in_line) {
    project_body(row, polygon, corners, seen, first, last);
    return;
  }
  for (std::size_t i = 0; i < corners; i += simd::kFour) {
    simd::Double4 us, vs, areas;
    simd::load(us, u + i);
    simd::load(vs, v + i);
    simd::load(areas, area + i);
    simd::store(u + corners + i, us);
    simd::store(v + corners + i, vs);
    simd::store(area + corners + i, areas);
  }
  const auto begin = static_cast<std::size_t>(std::countr_zero(begins)),
             end = begin + static_cast<std::size_t>(std::popcount(faces));
  // A beam enters a convex body by one edge, so one division serves all edges.
  const simd::Double4 none = {0, 0, 0, 0};
  for (std::size_t k = first; k <= last; k += simd::kFour) {
    simd::Double4 x, y, range, solid, areas = none, slopes = none;
    simd::load(x, row.x + k);
    simd::load(y, row.y + k);
    simd::load(range, row.range + k);
    simd::load(solid, row.solid + k);
    bodies::Side<simd::Double4> w0(x, y, u[begin], v[begin]);
    for (std::size_t i = begin; i < end; ++i) {
      const bodies::Side<simd::Double4> w1(x, y, u[i + 1], v[i + 1]);
      const bodies::Crossing<simd::Double4> ends(w0, w1);
      areas += ends.enters ? area[i] : none;
      slopes += ends.enters ? ends.slope : none;
      w0 = w1;
    }
    bodies::keep_first<simd::Double4>(areas / slopes, simd::Double4{seen, seen, seen, seen}, range, solid);
    simd::store(row.range + k, range);
    simd::store(row.solid + k, solid);
  }
}

/// Culling region: within `reach` of p, at height z, and not behind p along `ahead` by more than -`behind`.
struct Sector {
  geom::Vec2 p;
  double reach, z;
  geom::Vec2 ahead{0, 0};
  double behind = 0;
};

/// Centers relative to the sector's p along W's axes, and their places in the index.
struct Gathered {
  double *x, *y;  // m
  std::uint32_t* place;
};

/// Collects the discs of the runs that intersect a sector;
/// returns their number. `out` must have room for eight more.
PLAYHOUSE_INLINE std::size_t gather(const Sector& sector, double radius_max,
                                    const bodies::DiscIndex::Places& places,
                                    std::span<const bodies::DiscIndex::Run> runs, const Gathered& out) {
  const double *const from_x = places.x.data(), *const from_y = places.y.data();
  const double *const z_min = places.z_min.data(), *const z_max = places.z_max.data();
  const Sector s = sector;
  const double far = (s.reach + radius_max) * (s.reach + radius_max) + bodies::kMargin;
  const simd::Double4 number = {0, 1, 2, 3};
  std::size_t count = 0;
  for (const bodies::DiscIndex::Run& run : runs) {
    for (std::uint32_t i = run.begin; i < run.end; i += simd::kFour) {
      simd::Double4 x, y, low, high;
      simd::load(x, from_x + i);
      simd::load(y, from_y + i);
      simd::load(low, z_min + i);
      simd::load(high, z_max + i);
      x -= s.p.x;
      y -= s.p.y;
      const simd::Mask4 active = (low <= s.z) & (high >= s.z) & (x * x + y * y <= far) &
                                 (x * s.ahead.x + y * s.ahead.y >= s.behind) &
                                 (number < static_cast<double>(run.end - i));
      // Compacts: lanes that are not active are overwritten.
      for (std::uint32_t lane = 0; lane < simd::kFour; ++lane) {
        out.x[count] = x[lane];
        out.y[count] = y[lane];
        out.place[count] = i + lane;
        count -= static_cast<std::size_t>(active[lane]);
      }
    }
  }
  return count;
}

}  // namespace playhouse::rays
