#pragma once

/// The inner loops of bundles (bundle.cc): which of their rays may meet which bodies, and which they meet.

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "playhouse/stage/disc_index.h"
#include "playhouse/stage/polygon_hit.h"
#include "playhouse/stage/rays.h"
#include "playhouse/stage/vectors.h"

namespace playhouse::stage {

/// Puts the places of bodies that rays may meet, by where they are in `meets`, into `place`, and which rays
/// into `rays`; returns how many.
PLAYHOUSE_INLINE std::size_t find_bodies(const Bundle& bundle, const DiscIndex::Places& places,
                                         const std::vector<DiscIndex::Run>& runs, Vec2 p_WM, Rotation r,
                                         double z_low, double z_high, std::uint32_t* __restrict place,
                                         std::uint16_t* __restrict rays) {
  const double per_cell = 1.0 / bundle.cell, middle = bundle.half * per_cell + 1;
  const double c = r.c * per_cell, s = r.s * per_cell, far = bundle.half * bundle.half;
  const double *const from_x = places.x.data(), *const from_y = places.y.data();
  const double *const z_min = places.z_min.data(), *const z_max = places.z_max.data();
  const std::uint16_t* const meets = bundle.meets.data();
  const Four number = {0, 1, 2, 3};
  std::size_t count = 0;
  for (const DiscIndex::Run& run : runs) {
    for (std::uint32_t i = run.begin; i < run.end; i += kFour) {
      Four x, y, low, high;
      load(x, from_x + i);
      load(y, from_y + i);
      load(low, z_min + i);
      load(high, z_max + i);
      x -= p_WM.x;
      y -= p_WM.y;
      const auto matters = (x * x + y * y < far) & (low <= z_high) & (high >= z_low) &
                           (number < static_cast<double>(run.end - i));
      const Four row = matters ? c * y - s * x + middle : 0, column = matters ? c * x + s * y + middle : 0;
      const FourInts cell =
          __builtin_convertvector(row, FourInts) * static_cast<std::int32_t>(Bundle::kSide) +
          __builtin_convertvector(column, FourInts);
      for (std::uint32_t lane = 0; lane < kFour; ++lane) {  // what does not matter is overwritten
        place[count] = i + lane;
        rays[count] = meets[static_cast<std::size_t>(cell[lane])];
        count += rays[count] != 0;
      }
    }
  }
  return count;
}

/// A body that a ray may meet: its circle lies across the way.
struct Meeting {
  std::uint32_t place, ray;
};
inline constexpr std::size_t kMeetings = 256;

/// A number of each of four rays.
PLAYHOUSE_INLINE void load_rays(const double* column, const Meeting* four, Four& numbers) {
  numbers = Four{column[four[0].ray], column[four[1].ray], column[four[2].ray], column[four[3].ray]};
}

/// Keeps the first of what is known about rays and the bodies that they may meet, four at a time; behind the
/// last there is room for three.
PLAYHOUSE_INLINE void meet(const Space& space, Meeting* meetings, std::size_t count, Rays& rays) {
  for (std::size_t i = count; i % kFour != 0; ++i) meetings[i] = meetings[count - 1];
  for (std::size_t i = 0; i < count; i += kFour) {
    const Meeting* const four = meetings + i;
    const DiscIndex::Disc* disc[kFour];
    const Vec2* polygon[kFour];
    FourInts convex, row;
    for (std::size_t j = 0; j < kFour; ++j) {
      disc[j] = space.index.discs() + four[j].place;
      polygon[j] = space.solids.p.data() + disc[j]->first_vertex;
      convex[j] = static_cast<std::int32_t>(disc[j]->convex);
      row[j] = static_cast<std::int32_t>(disc[j]->row);
    }
    const Four corners = __builtin_convertvector(convex, Four), rows = __builtin_convertvector(row, Four);
    const std::int32_t most = std::max(std::max(convex[0], convex[1]), std::max(convex[2], convex[3]));
    Four px, py, dx, dy, t;
    load_rays(rays.px, four, px);
    load_rays(rays.py, four, py);
    load_rays(rays.dx, four, dx);
    load_rays(rays.dy, four, dy);
    entries(polygon, corners, static_cast<std::size_t>(most), px, py, dx, dy, t);
    if (any((t < 0) | (corners == 0)))
      for (std::size_t j = 0; j < kFour; ++j)
        t[j] = body_hit_here(polygon[j], disc[j]->vertices, convex[j] != 0, rays.p(four[j].ray),
                             rays.d(four[j].ray));
    for (std::size_t j = 0; j < kFour; ++j)
      keep_first_alone(t[j], rows[j], rays.range[four[j].ray], rays.solid[four[j].ray]);
  }
}

/// Keeps the first of what is known and the bodies at `place`, each for the rays, counted from `first`, that
/// its bits name; `heights`: those of the rays differ. Changes what is at `place` and `near`.
PLAYHOUSE_INLINE void meet_bodies(const Space& space, std::uint32_t own_root, std::uint32_t* place,
                                  std::uint16_t* near, std::size_t count, std::size_t first, bool heights,
                                  Rays& rays) {
  Meeting meetings[kMeetings + Bundle::kRays + kFour];
  std::size_t met = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const DiscIndex::Disc& disc = space.index.discs()[place[i]];
    if (disc.root == own_root || (disc.seen_by & bit(Observer::kRanger)) == 0) continue;
    const double radius = disc.radius + kMargin;
    unsigned left = near[i];
    do {  // branch-free: hits are unpredictable
      const auto k = static_cast<std::uint32_t>(first + static_cast<std::size_t>(std::countr_zero(left)));
      meetings[met] = {place[i], k};
      met += (std::fabs(geom::cross(rays.d(k), disc.center - rays.p(k))) <= radius) &
             (!heights || (disc.z_min <= rays.z[k] && rays.z[k] <= disc.z_max));
      left &= left - 1;
    } while (left != 0);
    if (met >= kMeetings) {
      meet(space, meetings, met, rays);
      met = 0;
    }
  }
  meet(space, meetings, met, rays);
}

}  // namespace playhouse::stage
