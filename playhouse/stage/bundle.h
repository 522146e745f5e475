#pragma once

/// The kernels of bundles (bundle.cc): which of their rays may meet which bodies, and which they meet. What
/// cannot be met is told eight at a time in single precision; where a ray meets a body is exact.
///
/// Each is in the program once for every set of instructions (bundle_kernels.inc over eight_plain.inc,
/// eight_avx2.inc, eight_avx512.inc), and all give the same ranges.

#include <cstdint>
#include <span>

#include "playhouse/stage/rays.h"
#include "playhouse/stage/space.h"

namespace playhouse::stage {

/// Bodies near a ranger, and its rays that may meet them. Behind the last there is room for eight more.
struct NearBodies {
  std::uint32_t* place;  // in the index
  std::uint32_t* cell;   // of the bundle's table
  std::uint16_t* rays;   // bit k: ray k of the bundle
};

/// Heights that rays are at.
struct Heights {
  double z_low, z_high;  // m
  bool is_all_seen;      // as of DiscIndex
};

/// Finds the bodies that rays may meet.
///
/// In: the bundle, where its ranger and its rays are; all that is near it is in the runs of the index, whose
/// radii are at
///   most what the bundle's table is good for.
/// Out: `place` and `rays`; changes `cell`. Returns how many.
/// Cost: 14 instructions for each of eight places in the runs, 9 for each that is near.
std::size_t find_bodies(const Bundle& bundle, const DiscIndex::Places& places,
                        std::span<const DiscIndex::Run> runs, Vec2 p_WM, Rotation r, const Heights& heights,
                        const NearBodies& out);

/// Keeps the first of what is known about rays and the first `count` bodies near them.
///
/// In: the bodies, seen by rangers, whose rays count from `first`; the rays do not see the tree of own_root.
/// Out: range and solid of the rays.
/// Cost: a vector of eight corners for each body and ray of it, and a division for each four that meet.
/// Source: a ray enters a convex outline between a corner on its left and the next one, on its right; the
///   rule is that of ray_edge.h.
void meet_bodies(const Space& space, std::uint32_t own_root, const NearBodies& near, std::size_t count,
                 std::size_t first, const Heights& heights, Rays& rays);

}  // namespace playhouse::stage
