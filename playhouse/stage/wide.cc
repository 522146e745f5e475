#include "playhouse/stage/wide.h"

#include <algorithm>

#ifdef __x86_64__
#include <immintrin.h>
#endif

#ifdef __x86_64__
#define PLAYHOUSE_WIDE PLAYHOUSE_TARGET_AVX512
namespace playhouse::stage::avx512 {
#include "playhouse/stage/wide_avx512.inc"
#include "playhouse/stage/wide_kernels.inc"
}  // namespace playhouse::stage::avx512
#undef PLAYHOUSE_WIDE
#endif

#define PLAYHOUSE_WIDE
namespace playhouse::stage::emulated {
#include "playhouse/stage/wide_emulated.inc"
#include "playhouse/stage/wide_kernels.inc"
}  // namespace playhouse::stage::emulated
