#pragma once

/// Eight-lane kernels of rays for processors with AVX-512: the hottest
/// functions of scan.h, with the same bits. Compilers do not generate its
/// instructions that compact lanes, so these use intrinsics. The plain version
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

namespace plain {
decltype(rays::project_facing) project_facing;
decltype(rays::gather) gather;
}  // namespace plain

#ifndef __x86_64__
namespace avx512 = plain;  // never chosen
#endif

}  // namespace playhouse::rays

namespace playhouse::simd {

template <auto kNative, auto kPortable>
struct Double8Versions {
  static constexpr bool kExists = true;
  static constexpr auto kAvx512 = kNative, kPlain = kPortable;
};
template <>
struct InDouble8<rays::project_facing>
    : Double8Versions<rays::avx512::project_facing, rays::plain::project_facing> {};
template <>
struct InDouble8<rays::gather> : Double8Versions<rays::avx512::gather, rays::plain::gather> {};

}  // namespace playhouse::simd
