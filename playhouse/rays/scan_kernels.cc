#include "playhouse/rays/scan_kernels.h"

#include <algorithm>

#ifdef __x86_64__
#include <immintrin.h>
#endif

#ifdef __x86_64__
#define PLAYHOUSE_LANES PLAYHOUSE_TARGET_AVX512
namespace playhouse::rays::avx512 {
#include "playhouse/rays/double8_avx512.inc"
#include "playhouse/rays/scan_kernels.inc"
}  // namespace playhouse::rays::avx512
#undef PLAYHOUSE_LANES
#endif

#define PLAYHOUSE_LANES
namespace playhouse::rays::plain {
#include "playhouse/rays/double8_plain.inc"
#include "playhouse/rays/scan_kernels.inc"
}  // namespace playhouse::rays::plain
