#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "playhouse/bodies/polygon_hit.h"
#include "playhouse/rays/bundle.h"
#include "playhouse/simd/vectors.h"

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace playhouse::rays {
namespace {

using Mask = std::uint32_t;  // bit i: lane i of eight

/// The first `count` lanes of eight.
constexpr Mask first_of(std::size_t count) {
  return count >= 8 ? 0xff : (1u << count) - 1;
}

}  // namespace
}  // namespace playhouse::rays

#define PLAYHOUSE_LANES inline
namespace playhouse::rays::plain {
namespace {
#include "playhouse/rays/float8_plain.inc"

#include "playhouse/rays/bundle_kernels.inc"
}  // namespace
}  // namespace playhouse::rays::plain
#undef PLAYHOUSE_LANES

#ifdef __x86_64__
#define PLAYHOUSE_LANES PLAYHOUSE_TARGET_AVX2 inline
namespace playhouse::rays::avx2 {
namespace {
#include "playhouse/rays/float8_avx.inc"

#include "playhouse/rays/float8_avx2.inc"

#include "playhouse/rays/bundle_kernels.inc"
}  // namespace
}  // namespace playhouse::rays::avx2
#undef PLAYHOUSE_LANES

#define PLAYHOUSE_LANES PLAYHOUSE_TARGET_AVX512 inline
namespace playhouse::rays::avx512 {
namespace {
#include "playhouse/rays/float8_avx.inc"

#include "playhouse/rays/float8_avx512.inc"

#include "playhouse/rays/bundle_kernels.inc"
}  // namespace
}  // namespace playhouse::rays::avx512
#undef PLAYHOUSE_LANES
#else
namespace playhouse::rays::avx2 = plain;
namespace playhouse::rays::avx512 = plain;
#endif

namespace playhouse::rays {

std::size_t find_bodies(const Bundle::Table& table, const bodies::DiscIndex::Places& places,
                        std::span<const bodies::DiscIndex::Run> runs, geom::Vec2 p_WM, geom::Rotation r,
                        std::uint32_t own_root, const Heights& heights, const NearBodies& out) {
  const auto find = simd::choose_version(plain::find_bodies, avx2::find_bodies, avx512::find_bodies);
  return find(table, places, runs, p_WM, r, own_root, heights, out);
}

void add_pairs(const bodies::Space& space, const NearBodies& near, std::size_t count, std::size_t first,
               const Heights& heights, Rays& rays, Pairs& pairs) {
  const auto add = simd::choose_version(plain::add_pairs, avx2::add_pairs, avx512::add_pairs);
  add(space, near, count, first, heights, rays, pairs);
}

void resolve_pairs(const bodies::Space& space, Rays& rays, Pairs& pairs) {
  const auto resolve = simd::choose_version(plain::resolve_pairs, avx2::resolve_pairs, avx512::resolve_pairs);
  resolve(space, rays, pairs);
}

}  // namespace playhouse::rays
