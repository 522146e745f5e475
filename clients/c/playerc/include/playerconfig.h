/** What this installation is, for programs that ask. */
#ifndef PLAYERCONFIG_H
#define PLAYERCONFIG_H

/** The version of Player whose protocol and names these are. */
#define PLAYER_VERSION "3.1.0"

/** What the system has. */
#define HAVE_CFMAKERAW 1
#define HAVE_CLOCK_GETTIME 1
#define HAVE_DIRNAME 1
#define HAVE_GETOPT 1
#define HAVE_GETTIMEOFDAY 1
#define HAVE_NANOSLEEP 1
#define HAVE_POLL 1
#define HAVE_POLLFD 1
#define HAVE_POLLIN 1
#define HAVE_RINT 1
#define HAVE_ROUND 1
#define HAVE_STDINT_H 1
#define HAVE_STRUCT_TIMESPEC 1
#define HAVE_USLEEP 1

#include <stdint.h>
#include <sys/types.h>

#endif /* PLAYERCONFIG_H */
