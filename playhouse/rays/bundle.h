#pragma once

/// The kernels of bundles (bundle.cc). Broad phase: which rays may hit which bodies,
/// conservatively, eight at a time in single precision. Narrow phase: the exact hits.
///
/// Each is in the program once for every set of instructions (bundle_kernels.inc over float8_plain.inc,
/// float8_avx2.inc, float8_avx512.inc), and all give the same ranges.

#include <cstdint>
#include <span>

#include "playhouse/bodies/space.h"
#include "playhouse/rays/rays.h"

namespace playhouse::rays {

/// Candidates of the broad phase: bodies and the rays that may hit them. Padded by eight.
struct NearBodies {
  std::uint32_t* place;  // in the index
  std::uint32_t* cell;   // of the bundle's table
  std::uint16_t* rays;   // bit k: ray k of the bundle
};

/// Height range of a bundle's rays.
struct Heights {
  double z_low, z_high;  // m
  bool is_all_seen;      // as of DiscIndex
};

/// Pairs of a ray and a body that it may hit, of many bundles. Room for all
/// rays of one body and two extra pairs: appends are branch-free and write before they count.
struct Pairs {
  static constexpr std::size_t kMost = 256, kRoom = kMost + Bundle::kRays + 2;
  std::uint32_t place[kRoom], ray[kRoom];  // of the body in the index, of the ray in Rays
  std::size_t count = 0;

  void add(std::uint32_t at, std::size_t k) {
    place[count] = at;
    ray[count] = static_cast<std::uint32_t>(k);
  }
};

/// Broad phase: finds the bodies that rays may hit.
///
/// In: a table of a bundle, the pose of its ranger, the heights of its rays; the tree of own_root is ignored.
///   `runs` of the index must cover its reach. Needs radii of at most what the table was made for.
///   (p_WM [m] and r: the ranger's pose in W.)
/// Out: `place` and `rays`; overwrites `cell`. Returns the number of candidates.
/// Cost: 16 instructions for each eight places in the runs, 9 for each candidate.
std::size_t find_bodies(const Bundle::Table& table, const bodies::DiscIndex::Places& places,
                        std::span<const bodies::DiscIndex::Run> runs, geom::Vec2 p_WM, geom::Rotation r,
                        std::uint32_t own_root, const Heights& heights, const NearBodies& out);

/// Narrow phase: appends the first `count` candidates to the pairs; a full list is resolved first.
///
/// In: candidates of a bundle, whose rays are `rays` from `first` on.
/// Out: pairs. Concave bodies and those with many corners are resolved here.
void add_pairs(const bodies::Space& space, const NearBodies& near, std::size_t count, std::size_t first,
               const Heights& heights, Rays& rays, Pairs& pairs);

/// Resolves all pairs: shortens the rays by their hits, and empties the list.
///
/// In: pairs of bodies that rangers see.
/// Out: range and solid of the rays.
/// Cost: a vector of eight corners for each pair, a division for each four hits. Pairs of several rangers
///   are resolved together: a loop over those of one is too short to be predicted.
/// Source: a ray enters a convex outline by the edge from a corner on its left to the next one on its right;
///   ties and edge cases as in ray_edge.h.
void resolve_pairs(const bodies::Space& space, Rays& rays, Pairs& pairs);

}  // namespace playhouse::rays
