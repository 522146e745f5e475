#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "playhouse/stage/bundle.h"
#include "playhouse/stage/polygon_hit.h"
#include "playhouse/stage/vectors.h"

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace playhouse::stage {
namespace {

using Mask = std::uint32_t;  // bit i: lane i of eight

/// The first `count` lanes of eight.
constexpr Mask first_of(std::size_t count) {
  return count >= 8 ? 0xff : (1u << count) - 1;
}

}  // namespace
}  // namespace playhouse::stage

#define PLAYHOUSE_EIGHT inline
namespace playhouse::stage::plain {
namespace {
#include "playhouse/stage/eight_plain.inc"

#include "playhouse/stage/bundle_kernels.inc"
}  // namespace
}  // namespace playhouse::stage::plain
#undef PLAYHOUSE_EIGHT

#ifdef __x86_64__
#define PLAYHOUSE_EIGHT PLAYHOUSE_TARGET_AVX2 inline
namespace playhouse::stage::avx2 {
namespace {
#include "playhouse/stage/eight_avx.inc"

#include "playhouse/stage/eight_avx2.inc"

#include "playhouse/stage/bundle_kernels.inc"
}  // namespace
}  // namespace playhouse::stage::avx2
#undef PLAYHOUSE_EIGHT

#define PLAYHOUSE_EIGHT PLAYHOUSE_TARGET_AVX512 inline
namespace playhouse::stage::avx512 {
namespace {
#include "playhouse/stage/eight_avx.inc"

#include "playhouse/stage/eight_avx512.inc"

#include "playhouse/stage/bundle_kernels.inc"
}  // namespace
}  // namespace playhouse::stage::avx512
#undef PLAYHOUSE_EIGHT
#else
namespace playhouse::stage::avx2 = plain;
namespace playhouse::stage::avx512 = plain;
#endif

namespace playhouse::stage {

std::size_t find_bodies(const Bundle::Table& table, const DiscIndex::Places& places,
                        std::span<const DiscIndex::Run> runs, Vec2 p_WM, Rotation r, std::uint32_t own_root,
                        const Heights& heights, const NearBodies& out) {
  const auto find = choose_version(plain::find_bodies, avx2::find_bodies, avx512::find_bodies);
  return find(table, places, runs, p_WM, r, own_root, heights, out);
}

void add_pairs(const Space& space, const NearBodies& near, std::size_t count, std::size_t first,
               const Heights& heights, Rays& rays, Pairs& pairs) {
  const auto add = choose_version(plain::add_pairs, avx2::add_pairs, avx512::add_pairs);
  add(space, near, count, first, heights, rays, pairs);
}

void resolve_pairs(const Space& space, Rays& rays, Pairs& pairs) {
  const auto resolve = choose_version(plain::resolve_pairs, avx2::resolve_pairs, avx512::resolve_pairs);
  resolve(space, rays, pairs);
}

}  // namespace playhouse::stage
