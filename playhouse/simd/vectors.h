#pragma once

/// Vector functions: f(a, b) is written as a PLAYHOUSE_INLINE function and called as
/// in_vectors<f>(a, b). It is compiled twice, for the baseline processor and for
/// AVX2, and dispatched at run time (instruction_set.h). Both give the same bits: no
/// fused multiply-add, no reordering, only four lanes at a time. A lambda in it is
/// compiled for the baseline unless it is inlined: keep loops in the function itself.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

/// For vector functions and what they call: inlined into each version.
#define PLAYHOUSE_INLINE inline __attribute__((always_inline))

namespace playhouse::simd {

/// See instruction_set.h; here so that dispatch is a single load. Kernels of eight lanes are written by hand, in
/// AVX-512 or plain, to test them on any processor.
enum class EightLanes : std::uint8_t { kNone, kAvx512, kPlain };
extern bool vectors_use_avx2;
extern EightLanes eight_lanes;

/// A vector function by hand over eight doubles:
/// kAvx512 and kPlain, where it pays (rays/scan_kernels.h).
template <auto kFunction>
struct InDouble8 {
  static constexpr bool kExists = false;
};

/// The versions of a function.
template <auto kFunction>
struct Versions;
template <typename Value, typename... Arguments, Value (*kFunction)(Arguments...)>
struct Versions<kFunction> {
  [[gnu::noinline]] static Value plain(Arguments... arguments) { return kFunction(arguments...); }
#ifdef __x86_64__
  [[gnu::noinline, gnu::target("avx2")]] static Value avx2(Arguments... arguments) {
    return kFunction(arguments...);
  }
#else
  static Value avx2(Arguments... arguments) {
    return plain(arguments...);
  }
#endif
  /// Out of line: only a tail call, not worth inlining.
  [[gnu::noinline]] static Value call(Arguments... arguments) {
    if constexpr (InDouble8<kFunction>::kExists) {
      if (eight_lanes == EightLanes::kAvx512) return InDouble8<kFunction>::kAvx512(arguments...);
      if (eight_lanes == EightLanes::kPlain) return InDouble8<kFunction>::kPlain(arguments...);
    }
    return narrow(arguments...);
  }
  /// The four-lane version, even if AVX-512 is available.
  static Value narrow(Arguments... arguments) {
    return vectors_use_avx2 ? avx2(arguments...) : plain(arguments...);
  }
};
template <auto kFunction>
inline constexpr auto in_vectors = Versions<kFunction>::call;

/// The version for the chosen instruction set of a kernel that is compiled in a namespace for each
/// (bundle_kernels.cc): its source is included over types of that set, with these attributes.
template <typename Kernel>
Kernel* choose_version(Kernel* plain, Kernel* avx2, Kernel* avx512) {
  if (eight_lanes == EightLanes::kAvx512) return avx512;
  return vectors_use_avx2 && eight_lanes == EightLanes::kNone ? avx2 : plain;
}
#define PLAYHOUSE_TARGET_AVX2 __attribute__((target("avx2,bmi,popcnt")))
#define PLAYHOUSE_TARGET_AVX512 __attribute__((target("avx512f,avx512dq,avx512vl,bmi,popcnt")))

/// Vectors on any processor, named after type and number of lanes.
inline constexpr std::size_t kFour = 4, kEight = 8;
using Double4 = double __attribute__((vector_size(kFour * sizeof(double))));
using Double2 = double __attribute__((vector_size(2 * sizeof(double))));
using Int4 = std::int32_t __attribute__((vector_size(kFour * sizeof(std::int32_t))));
using Mask4 = decltype(Double4() < Double4());
using Float8 = float __attribute__((vector_size(kEight * sizeof(float))));
using Int8 = std::int32_t __attribute__((vector_size(kEight * sizeof(std::int32_t))));

template <typename Vector, typename Number>
PLAYHOUSE_INLINE void load(Vector& v, const Number* from) {
  static_assert(std::is_same_v<std::remove_cvref_t<decltype(v[0])>, Number>);
  std::memcpy(&v, from, sizeof v);
}
template <typename Vector, typename Number>
PLAYHOUSE_INLINE void store(Number* to, const Vector& v) {
  static_assert(std::is_same_v<std::remove_cvref_t<decltype(v[0])>, Number>);
  std::memcpy(to, &v, sizeof v);
}

PLAYHOUSE_INLINE bool any(const Mask4& truths) {
  return ((truths[0] | truths[1]) | (truths[2] | truths[3])) != 0;
}

}  // namespace playhouse::simd
