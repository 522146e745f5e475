#pragma once

/// Eight-lane kernels of rays for processors with AVX-512: the hottest
/// functions of scan.h, with the same bits. Compilers do not generate its
/// masked compress-stores, so these use intrinsics. The emulated version
/// runs the same kernels on any processor, so that they are always tested.
///
/// In, Out: as for the functions of the same names in scan.h.
/// Cost: bench laser takes 0.83 of its time with AVX2 (docs/benchmarks.md).

#include "playhouse/rays/scan.h"

namespace playhouse::rays {

#ifdef __x86_64__
namespace avx512 {
decltype(rays::project_facing) project_facing;
decltype(rays::gather) gather;
}  // namespace avx512
#endif

namespace emulated {
decltype(rays::project_facing) project_facing;
decltype(rays::gather) gather;
}  // namespace emulated

#ifndef __x86_64__
namespace avx512 = emulated;  // never chosen
#endif

}  // namespace playhouse::rays

namespace playhouse::simd {

template <auto kNative, auto kPortable>
struct WideVersions {
  static constexpr bool kExists = true;
  static constexpr auto kAvx512 = kNative, kEmulated = kPortable;
};
template <>
struct Wide<rays::project_facing>
    : WideVersions<rays::avx512::project_facing, rays::emulated::project_facing> {};
template <>
struct Wide<rays::gather> : WideVersions<rays::avx512::gather, rays::emulated::gather> {};

}  // namespace playhouse::simd
