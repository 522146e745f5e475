#pragma once

/// The inner loops of scans (scan.cc): bodies near a scanner, projected onto a row of beams.

#include <algorithm>
#include <bit>
#include <vector>

#include "playhouse/stage/disc_index.h"
#include "playhouse/stage/polygon_hit.h"
#include "playhouse/stage/ranger_kinds.h"
#include "playhouse/stage/vectors.h"

namespace playhouse::stage {

// Beams are handled up to eight at a time; the columns of a row are that much longer than it.
static_assert(Scan::kSpare >= kEight);

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

/// A convex body from anywhere, beam by beam.
PLAYHOUSE_INLINE void project_body(const Row& row, const Vec2* polygon, std::size_t corners, double seen,
                                   std::size_t first, std::size_t last) {
  for (std::size_t k = first; k <= last; ++k)
    keep_first_alone(body_hit_here(polygon, corners, true, row.p, {row.x[k], row.y[k]}), seen, row.range[k],
                     row.solid[k]);
}

/// True if each of these beams has met something at `nearest` or before.
PLAYHOUSE_INLINE bool is_hidden(const Row& row, double nearest, std::size_t first, std::size_t last) {
  bool hidden = true;
  for (std::size_t k = first; k <= last && hidden; ++k) hidden = row.range[k] <= nearest;
  return hidden;
}

/// A convex body from outside, at a distance of up to `farthest`, all within the beams first .. last:
/// projects the edges that face the scanner, unless every beam has met something nearer than `nearest`.
PLAYHOUSE_INLINE void project_facing(const Row& row, const Vec2* __restrict polygon, std::size_t corners,
                                     double seen, double nearest, double farthest, std::size_t first,
                                     std::size_t last) {
  if (is_hidden(row, nearest, first, last)) return;

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
/// eight more.
PLAYHOUSE_INLINE std::size_t gather(const Sector& sector, double radius_max, const DiscIndex::Places& places,
                                    std::span<const DiscIndex::Run> runs, const Gathered& out) {
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

}  // namespace playhouse::stage
