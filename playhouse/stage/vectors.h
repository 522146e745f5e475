#pragma once

/// PLAYHOUSE_VECTORS: compiles a function a second time for processors with AVX2 and picks one when the
/// program starts. Both give the same bits: nothing is fused or reordered, only done four at a time.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define PLAYHOUSE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define PLAYHOUSE_VECTORS
#endif

/// For what functions with PLAYHOUSE_VECTORS are made of: becomes a part of each of their versions.
#define PLAYHOUSE_INLINE inline __attribute__((always_inline))

namespace playhouse::stage {

/// Numbers that are worked on together, on any processor: four that are exact, or eight where half the digits
/// do.
inline constexpr std::size_t kFour = 4, kEight = 8;
using Four = double __attribute__((vector_size(kFour * sizeof(double))));
using FourInts = std::int32_t __attribute__((vector_size(kFour * sizeof(std::int32_t))));
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

}  // namespace playhouse::stage
