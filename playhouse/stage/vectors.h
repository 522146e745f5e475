#pragma once

/// Vector functions: f(a, b) is written as a PLAYHOUSE_INLINE function and called as in_vectors<f>(a, b). It
/// is compiled twice, for any processor and for those with AVX2, and instruction_set.h says which one runs.
/// Both give the same bits: nothing is fused or reordered, only done four at a time. A lambda in a vector
/// function is compiled for any processor, unless it becomes a part of it: loops belong into the function
/// itself.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

/// For vector functions and what they are made of: becomes a part of each version.
#define PLAYHOUSE_INLINE inline __attribute__((always_inline))

namespace playhouse::stage {

/// See instruction_set.h; here so that a call costs one look.
enum class WideKernels : std::uint8_t { kNone, kAvx512, kEmulated };
extern bool vectors_use_avx2;
extern WideKernels wide_kernels;

/// What does the same with eight numbers at a time as a vector function does: kAvx512 and kEmulated, where it
/// is worth while (wide.h).
template <auto kFunction>
struct Wide {
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
  /// Not a part of its callers: it has nothing to do but to jump on.
  [[gnu::noinline]] static Value call(Arguments... arguments) {
    if constexpr (Wide<kFunction>::kExists) {
      if (wide_kernels == WideKernels::kAvx512) return Wide<kFunction>::kAvx512(arguments...);
      if (wide_kernels == WideKernels::kEmulated) return Wide<kFunction>::kEmulated(arguments...);
    }
    return narrow(arguments...);
  }
  /// By the version for four numbers, whatever the processor has.
  static Value narrow(Arguments... arguments) {
    return vectors_use_avx2 ? avx2(arguments...) : plain(arguments...);
  }
};
template <auto kFunction>
inline constexpr auto in_vectors = Versions<kFunction>::call;

/// Numbers that are worked on together, on any processor: four that are exact, or eight where half the digits
/// do.
inline constexpr std::size_t kFour = 4, kEight = 8;
using Four = double __attribute__((vector_size(kFour * sizeof(double))));
using Two = double __attribute__((vector_size(2 * sizeof(double))));
using FourInts = std::int32_t __attribute__((vector_size(kFour * sizeof(std::int32_t))));
using FourTruths = decltype(Four() < Four());
using Eight = float __attribute__((vector_size(kEight * sizeof(float))));
using EightInts = std::int32_t __attribute__((vector_size(kEight * sizeof(std::int32_t))));

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

PLAYHOUSE_INLINE bool any(const FourTruths& truths) {
  return ((truths[0] | truths[1]) | (truths[2] | truths[3])) != 0;
}

}  // namespace playhouse::stage
