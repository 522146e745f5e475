/** Small things that old programs expect of Player's headers. */
#ifndef LIBPLAYERCOMMON_PLAYERCOMMON_H
#define LIBPLAYERCOMMON_PLAYERCOMMON_H

#include <math.h>

#ifndef M_PI
#define M_PI 3.14159265358979323846
#endif

#ifndef BOOL
#define BOOL int
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

#endif /* LIBPLAYERCOMMON_PLAYERCOMMON_H */
