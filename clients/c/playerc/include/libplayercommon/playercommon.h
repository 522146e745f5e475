/** Small things that old programs expect of Player's headers. */
#ifndef LIBPLAYERCOMMON_PLAYERCOMMON_H
#define LIBPLAYERCOMMON_PLAYERCOMMON_H

#include <assert.h>
#include <limits.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/param.h> /* as theirs, which has signal.h within */

#ifndef M_PI
#define M_PI 3.14159265358979323846
#endif

#ifndef BOOL
#define BOOL int
#endif
#ifndef __cplusplus
#ifndef true
#define true 1
#endif
#ifndef false
#define false 0
#endif
#endif
#ifndef TRUE
#define TRUE 1
#endif
#ifndef FALSE
#define FALSE 0
#endif

#ifndef MIN
#define MIN(a, b) ((a) < (b) ? (a) : (b))
#endif
#ifndef MAX
#define MAX(a, b) ((a) > (b) ? (a) : (b))
#endif

/** From degrees to radians, and back. */
#ifndef DTOR
#define DTOR(d) ((d) * (M_PI / 180.0))
#endif
#ifndef RTOD
#define RTOD(r) ((r) * (180.0 / M_PI))
#endif

/** The same angle (rad) within [-pi, pi]. */
#ifndef NORMALIZE
#define NORMALIZE(a) atan2(sin(a), cos(a))
#endif

/** The nearest number to `a` within [low, high]. */
#ifndef LIMIT
#define LIMIT(a, low, high) ((a) < (low) ? (low) : (a) > (high) ? (high) : (a))
#endif

#define VERIFY(m) assert(m)
#define MAX_FILENAME_SIZE PATH_MAX

/** Of an array, not of a pointer. */
#ifndef ARRAYSIZE
#define ARRAYSIZE(x) ((int)(sizeof(x) / sizeof((x)[0])))
#endif
#define ASSERT_INDEX(index, array) assert((size_t)(index) < sizeof(array) / sizeof((array)[0]))

#define LOBYTE(w) ((uint8_t)((w)&0xFF))
#define HIBYTE(w) ((uint8_t)(((w) >> 8) & 0xFF))
#define MAKEUINT16(lo, hi) ((uint16_t)(((uint16_t)(hi) << 8) | (uint16_t)(lo)))

#endif /* LIBPLAYERCOMMON_PLAYERCOMMON_H */
