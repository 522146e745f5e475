#include "playhouse/stage/wide.h"

#include <algorithm>

#ifdef __x86_64__
#include <immintrin.h>
#endif

#ifdef __x86_64__
#define PLAYHOUSE_WIDE __attribute__((target("avx512f,avx512dq,avx512vl,bmi,popcnt")))
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
