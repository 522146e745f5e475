#pragma once

#include <cstddef>

/// PLAYHOUSE_VECTORS: compiles a function a second time for processors with AVX2 and picks one when the
/// program starts. Both give the same bits: nothing is fused or reordered, only done four at a time.

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define PLAYHOUSE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define PLAYHOUSE_VECTORS
#endif

namespace playhouse::stage {

/// Four numbers that are worked on together, on any processor.
inline constexpr std::size_t kFour = 4;
using Four = double __attribute__((vector_size(kFour * sizeof(double))));

}  // namespace playhouse::stage
