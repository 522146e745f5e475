/** What clients include of it: constants, messages and their names. Drivers are of another kind here (docs/plugins.md). */
#ifndef LIBPLAYERCORE_PLAYERCORE_H
#define LIBPLAYERCORE_PLAYERCORE_H

#include <libplayercommon/playercommon.h>
#include <libplayerinterface/interface_util.h>
#include <libplayerinterface/player.h>
#include <playerconfig.h>

#endif /* LIBPLAYERCORE_PLAYERCORE_H */
