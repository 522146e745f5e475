/** What this installation is, for programs that ask. */
#ifndef PLAYERCONFIG_H
#define PLAYERCONFIG_H

/** The version of Player whose protocol and names these are. */
#define PLAYER_VERSION "3.1.0"

#endif /* PLAYERCONFIG_H */
