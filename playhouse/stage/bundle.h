#pragma once

/// The inner loop of bundles (bundle.cc): which of their rays may meet which bodies.

#include <cstdint>
#include <vector>

#include "playhouse/stage/disc_index.h"
#include "playhouse/stage/ranger_kinds.h"
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

}  // namespace playhouse::stage
