#pragma once

/// Kernels of rays that work on eight numbers at a time, for processors with AVX-512: those of scan.h
/// that take most of the time there, to the same bits. Compilers do not make use of its masks and
/// packed stores, so these are written with intrinsics. Emulated, the same kernels run on any processor, so
/// that they are tested on all.
///
/// In, Out: as of the functions of the same names in scan.h.
/// Cost: bench laser takes 0.83 of the time that it takes with AVX2 (docs/benchmarks.md).

#include "playhouse/stage/scan.h"

namespace playhouse::stage {

#ifdef __x86_64__
namespace avx512 {
decltype(stage::project_facing) project_facing;
decltype(stage::gather) gather;
}  // namespace avx512
#endif

namespace emulated {
decltype(stage::project_facing) project_facing;
decltype(stage::gather) gather;
}  // namespace emulated

#ifndef __x86_64__
namespace avx512 = emulated;  // never chosen
#endif

template <auto kNative, auto kPortable>
struct WideVersions {
  static constexpr bool kExists = true;
  static constexpr auto kAvx512 = kNative, kEmulated = kPortable;
};
template <>
struct Wide<project_facing> : WideVersions<avx512::project_facing, emulated::project_facing> {};
template <>
struct Wide<gather> : WideVersions<avx512::gather, emulated::gather> {};

}  // namespace playhouse::stage
