#pragma once

/// Kernels of rays that work on eight numbers at a time, for processors with AVX-512: those of scan.h and
/// bundle.h that take most of the time there, to the same bits. Compilers do not make use of its masks and
/// packed stores, so these are written with intrinsics. Emulated, the same kernels run on any processor, so
/// that they are tested on all.
///
/// In, Out: as of the functions of the same names in scan.h and bundle.h.
/// Cost: bench laser takes 0.83 of the time that it takes with AVX2, bench sonar 0.95 (docs/benchmarks.md).

#include <cstdint>

#include "playhouse/stage/bundle.h"
#include "playhouse/stage/scan.h"

namespace playhouse::stage {

#ifdef __x86_64__
namespace avx512 {
void project_facing(const Row& row, const Vec2* polygon, std::size_t corners, double seen, double nearest,
                    double farthest, std::size_t first, std::size_t last);
std::size_t gather(const Sector& sector, double radius_max, const DiscIndex::Places& places,
                   const std::vector<DiscIndex::Run>& runs, const Gathered& out);
std::size_t find_bodies(const Bundle& bundle, const DiscIndex::Places& places,
                        const std::vector<DiscIndex::Run>& runs, Vec2 p_WM, Rotation r, double z_low,
                        double z_high, std::uint32_t* place, std::uint16_t* rays);
}  // namespace avx512
#endif

namespace emulated {
void project_facing(const Row& row, const Vec2* polygon, std::size_t corners, double seen, double nearest,
                    double farthest, std::size_t first, std::size_t last);
std::size_t gather(const Sector& sector, double radius_max, const DiscIndex::Places& places,
                   const std::vector<DiscIndex::Run>& runs, const Gathered& out);
std::size_t find_bodies(const Bundle& bundle, const DiscIndex::Places& places,
                        const std::vector<DiscIndex::Run>& runs, Vec2 p_WM, Rotation r, double z_low,
                        double z_high, std::uint32_t* place, std::uint16_t* rays);
}  // namespace emulated

#ifndef __x86_64__
namespace avx512 = emulated;  // never chosen
#endif

template <>
struct Wide<project_facing> {
  static constexpr bool kExists = true;
  static constexpr auto kAvx512 = avx512::project_facing, kEmulated = emulated::project_facing;
};
template <>
struct Wide<gather> {
  static constexpr bool kExists = true;
  static constexpr auto kAvx512 = avx512::gather, kEmulated = emulated::gather;
};
template <>
struct Wide<find_bodies> {
  static constexpr bool kExists = true;
  static constexpr auto kAvx512 = avx512::find_bodies, kEmulated = emulated::find_bodies;
};

}  // namespace playhouse::stage
